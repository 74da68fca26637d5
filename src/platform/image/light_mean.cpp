#include "image/light_mean.h"

#include <algorithm>
#include <cstddef>

namespace rotatebook::image {

LightMean::LightMean(int width, int height)
    : width_(width),
      height_(height),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void LightMean::add(ImageView picture) {
  LightSum* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4) (sum++)->add(pixel, 1);
  }
  ++count_;
}

void LightMean::take(Image& picture) {
  const LightSum* sum = sums_.data();
  for (int y = 0; y < height_; ++y) {
    std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < width_; ++x, pixel += 4) (sum++)->mean(count_, pixel);
  }
  std::ranges::fill(sums_, LightSum());
  count_ = 0;
}

}  // namespace rotatebook::image
