// Pictures of a patch that moves over noise, with marks.
#pragma once

#include <cstdint>
#include <random>

#include "image/image.h"

namespace rotatebook::image::testing {

inline void fillWithNoise(Image& picture, const Area& area, unsigned seed) {
  std::mt19937 noise(seed);
  const std::ptrdiff_t size = bytesPerPixel(picture.format());
  for (int y = area.y; y < area.bottom(); ++y) {
    for (std::ptrdiff_t i = area.x * size; i < area.right() * size; ++i)
      picture.row(y)[i] = static_cast<std::uint8_t>(noise());
  }
}

/// Draws pictures anew over the last but one.
class MovingPicture {
 public:
  MovingPicture(int width, int height)
      : ground_(width, height, PixelFormat::Rgba8), rest_(width, height, PixelFormat::Rgba8) {
    fillWithNoise(ground_, ground_.area(), 1);
    rest_ = ground_;
    fillWithNoise(rest_, common({0, height / 2, width, 9}, rest_.area()), 2);
    rest_.mark();
  }

  /// Returns a picture with a patch at that place, valid until the next call but one.
  const Image& with(const Area& patch) {
    Image& picture = pictures_[++drawn_ % 2];
    picture.beginOn(ground_);
    picture.touch(patch);
    fillWithNoise(picture, common(patch, picture.area()), 100 + drawn_);
    picture.settle(rest_);
    return picture;
  }

  const Image& ground() const { return ground_; }
  const Image& rest() const { return rest_; }

 private:
  Image ground_, rest_, pictures_[2];
  unsigned drawn_ = 0;
};

/// Places of a patch: within a tile, over several, at borders, outside, and gone.
inline constexpr Area kPatches[] = {{5, 3, 20, 9},    {60, 10, 30, 30}, {63, 15, 1, 1},
                                    {64, 16, 64, 16}, {-5, -5, 20, 20}, {140, 30, 90, 90},
                                    {0, 0, 0, 0},     {127, 0, 2, 60},  {900, 900, 5, 5}};

}  // namespace rotatebook::image::testing
