#include "image/smaller.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "image/srgb.h"

namespace rotatebook::image {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// 4x2 pixels, of which the left four are these.
Image large(const std::array<Pixel, 4>& left) {
  Image picture(4, 2, PixelFormat::Rgba8);
  for (int i = 0; i < 4; ++i) {
    std::ranges::copy(left[static_cast<std::size_t>(i)], picture.row(i / 2) + 4 * (i % 2));
  }
  return picture;
}

Pixel halved(const std::array<Pixel, 4>& left) {
  Image picture(2, 1, PixelFormat::Rgba8);
  halve(large(left), picture);
  EXPECT_EQ(picture.row(0)[7], 0);  // The right four are empty.
  Pixel pixel{};
  std::copy_n(picture.row(0), 4, pixel.begin());
  return pixel;
}

TEST(Smaller, KeepsOneColour) {
  for (const Pixel& pixel : {Pixel{7, 100, 250, 255}, {3, 2, 1, 128}}) {
    EXPECT_EQ(halved({pixel, pixel, pixel, pixel}), pixel);
  }
}

TEST(Smaller, TakesTheMeanOfLight) {
  const Pixel white{255, 255, 255, 255}, black{0, 0, 0, 255};
  const std::uint8_t half = srgbFromLinear(0.5);
  EXPECT_EQ(halved({white, black, black, white}), (Pixel{half, half, half, 255}));
}

TEST(Smaller, CountsPixelsByTheirAlpha) {
  const Pixel red{200, 0, 0, 255}, clear{0, 90, 0, 0};
  EXPECT_EQ(halved({red, clear, clear, clear}), (Pixel{200, 0, 0, 64}));
}

}  // namespace
}  // namespace rotatebook::image
