#include "image/downsample.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "image/srgb_formula.h"

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
  downsample(large(left), picture.area(), picture.from(0, 0));
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

/// A picture of grey pixels.
Image grey(int width, const std::vector<std::uint8_t>& pixels) {
  Image picture(width, static_cast<int>(pixels.size()) / width, PixelFormat::Rgb8);
  for (std::size_t i = 0; i < pixels.size(); ++i) std::fill_n(picture.row(0) + 3 * i, 3, pixels[i]);
  return picture;
}

TEST(HalvedOpaque, TakesTheMeanOfLight) {
  const std::uint8_t half = srgbFromLinear(0.5);
  EXPECT_EQ(downsampledOpaque(grey(4, {255, 0, 9, 9, 0, 255, 9, 9}).view()), grey(2, {half, 9}));
}

TEST(HalvedOpaque, CountsPixelsOfAnOddSideInPart) {
  // Two pixels for five: each covers two and a half.
  const std::uint8_t first = srgbFromLinear(1 / 2.5), last = srgbFromLinear(0.5 / 2.5);
  EXPECT_EQ(downsampledOpaque(grey(5, {255, 0, 0, 0, 0}).view()), grey(2, {first, 0}));
  EXPECT_EQ(downsampledOpaque(grey(5, {0, 0, 255, 0, 0}).view()), grey(2, {last, last}));
  EXPECT_EQ(downsampledOpaque(grey(1, {0, 0, 0, 0, 255}).view()), grey(1, {0, first}));
}

TEST(HalvedOpaque, KeepsASideOfOne) {
  EXPECT_EQ(downsampledOpaque(grey(1, {77}).view()), grey(1, {77}));
  EXPECT_EQ(downsampledOpaque(grey(3, {77, 77, 77}).view()), grey(1, {77}));
}

TEST(HalvedOpaque, LeavesAlphaOut) {
  Image clear(2, 2, PixelFormat::Rgba8);
  for (int i = 0; i < 4; ++i) clear.row(0)[4 * i] = 200;
  Image red(1, 1, PixelFormat::Rgb8);
  red.row(0)[0] = 200;
  EXPECT_EQ(downsampledOpaque(clear.view()), red);
}

TEST(HalvedApart, TakesTheMeanOfAlphaWhichWeighsNothing) {
  Image picture(2, 2, PixelFormat::Rgba8);
  for (int i = 0; i < 4; ++i) {
    std::uint8_t* pixel = picture.row(0) + 4 * i;
    pixel[0] = i < 2 ? 255 : 0, pixel[3] = static_cast<std::uint8_t>(i == 0 ? 102 : 0);
  }
  Image mean(1, 1, PixelFormat::Rgba8);
  mean.row(0)[0] = srgbFromLinear(0.5), mean.row(0)[3] = 26;
  EXPECT_EQ(downsampledApart(picture.view()), mean);
}

TEST(HalvedApart, HasTheColoursOfTheOpaque) {
  const Image large = grey(5, {255, 0, 3, 40, 0, 7, 99, 200, 1, 2});
  Image apart(5, 2, PixelFormat::Rgba8);
  for (int i = 0; i < 10; ++i) std::copy_n(large.row(0) + 3 * i, 3, apart.row(0) + 4 * i);
  EXPECT_EQ(downsampledOpaque(downsampledApart(apart.view()).view()),
            downsampledOpaque(downsampledOpaque(large.view()).view()));
}

}  // namespace
}  // namespace rotatebook::image
