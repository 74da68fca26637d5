#include "image/linear_mean.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace rotatebook::image {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

Image pictureOf(const Pixel& left, const Pixel& right) {
  Image picture(2, 1, PixelFormat::Rgba8);
  std::copy(left.begin(), left.end(), picture.row(0));
  std::copy(right.begin(), right.end(), picture.row(0) + 4);
  return picture;
}

Pixel pixelAt(const Image& picture, int x) {
  const std::uint8_t* pixel = picture.row(0) + 4 * static_cast<std::ptrdiff_t>(x);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

TEST(LinearMean, IsOfLightNotOfNumbers) {
  LinearMean mean(2, 1);
  mean.add(pictureOf({255, 0, 0, 255}, {10, 20, 30, 255}).view());
  mean.add(pictureOf({0, 0, 255, 255}, {10, 20, 30, 255}).view());
  Image picture(2, 1, PixelFormat::Rgba8);
  mean.take(picture);
  EXPECT_EQ(pixelAt(picture, 0), (Pixel{188, 0, 188, 255}));  // The mean of the numbers is 128.
  EXPECT_EQ(pixelAt(picture, 1), (Pixel{10, 20, 30, 255}));
}

TEST(LinearMean, KeepsEveryNumberOfEqualPictures) {
  Image picture(2, 1, PixelFormat::Rgba8);
  LinearMean mean(2, 1);
  for (int number = 0; number < 256; ++number) {
    const auto value = static_cast<std::uint8_t>(number);
    // As many as there may be: the sums of white fill their 32 bits.
    for (int i = 0; i < 256; ++i) mean.add(pictureOf({value, 0, 0, 255}, {0, value, 0, 7}).view());
    mean.take(picture);
    EXPECT_EQ(pixelAt(picture, 0), (Pixel{value, 0, 0, 255}));
    EXPECT_EQ(pixelAt(picture, 1), (Pixel{0, value, 0, 7}));
  }
}

TEST(LinearMean, CountsPixelsByTheirAlpha) {
  LinearMean mean(2, 1);
  mean.add(pictureOf({200, 100, 50, 255}, {0, 0, 0, 0}).view());
  mean.add(pictureOf({0, 0, 0, 0}, {0, 0, 0, 0}).view());
  Image picture(2, 1, PixelFormat::Rgba8);
  mean.take(picture);
  EXPECT_EQ(pixelAt(picture, 0), (Pixel{200, 100, 50, 128}));
  EXPECT_EQ(pixelAt(picture, 1), (Pixel{0, 0, 0, 0}));
}

TEST(LinearMean, BeginsAnew) {
  LinearMean mean(2, 1);
  Image picture(2, 1, PixelFormat::Rgba8);
  mean.add(pictureOf({255, 255, 255, 255}, {255, 255, 255, 255}).view());
  mean.take(picture);
  mean.add(pictureOf({1, 2, 3, 255}, {4, 5, 6, 255}).view());
  mean.take(picture);
  EXPECT_EQ(pixelAt(picture, 0), (Pixel{1, 2, 3, 255}));
}

}  // namespace
}  // namespace rotatebook::image
