#include "image/layer.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace rotatebook::image {
namespace {

using Rgba = std::array<int, 4>;

Image greyPicture(PixelFormat format) {
  Image picture(4, 3, format);
  for (int y = 0; y < 3; ++y) {
    for (int i = 0; i < 4 * bytesPerPixel(format); ++i) picture.row(y)[i] = 100;
  }
  return picture;
}

Rgba rgbaAt(const Image& picture, int x, int y) {
  const int size = bytesPerPixel(picture.format());
  const std::uint8_t* pixel = picture.row(y) + x * size;
  return {pixel[0], pixel[1], pixel[2], size == 4 ? pixel[3] : 255};
}

// Two pixels: opaque red, and blue that covers half.
Layer twoPixels(int x, int y) {
  return {x, y, 2, 1, {0, 0, 255, 255, 128, 0, 0, 128}};
}

TEST(Blend, CoversByOpacity) {
  Image picture = greyPicture(PixelFormat::Rgb8);
  blend(twoPixels(1, 2), picture);
  EXPECT_EQ(rgbaAt(picture, 0, 2), (Rgba{100, 100, 100, 255}));
  EXPECT_EQ(rgbaAt(picture, 1, 2), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(rgbaAt(picture, 2, 2), (Rgba{50, 50, 178, 255}));
  EXPECT_EQ(rgbaAt(picture, 3, 2), (Rgba{100, 100, 100, 255}));
  EXPECT_EQ(rgbaAt(picture, 1, 1), (Rgba{100, 100, 100, 255}));
}

TEST(Blend, AddsToTheAlphaOfThePicture) {
  Image picture = greyPicture(PixelFormat::Rgba8);
  blend(twoPixels(0, 0), picture);
  EXPECT_EQ(rgbaAt(picture, 0, 0)[3], 255);
  EXPECT_EQ(rgbaAt(picture, 1, 0)[3], 128 + 50);
  EXPECT_EQ(rgbaAt(picture, 2, 0)[3], 100);
}

TEST(Blend, KeepsItsColourWhereThePictureIsTransparent) {
  Image picture(4, 3, PixelFormat::Rgba8);
  blend(twoPixels(0, 0), picture);
  EXPECT_EQ(rgbaAt(picture, 0, 0), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(rgbaAt(picture, 1, 0), (Rgba{0, 0, 255, 128}));
  EXPECT_EQ(rgbaAt(picture, 2, 0), (Rgba{0, 0, 0, 0}));
}

TEST(Blend, IsTheSameOnRgbAndOnOpaqueRgba) {
  Layer layer{1, 0, 3, 3, {}};
  for (int i = 0; i < 9; ++i) {
    const auto alpha = static_cast<std::uint8_t>(29 * i);
    for (const int part : {1, 2, 3, 4}) {
      layer.pixels.push_back(static_cast<std::uint8_t>(alpha * part / 4));
    }
  }
  Image rgb = greyPicture(PixelFormat::Rgb8), rgba = greyPicture(PixelFormat::Rgba8);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) rgba.row(y)[4 * x + 3] = 255;
  }
  blend(layer, rgb);
  blend(layer, rgba);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) EXPECT_EQ(rgbaAt(rgb, x, y), rgbaAt(rgba, x, y)) << x << y;
  }
  EXPECT_NE(rgb, greyPicture(PixelFormat::Rgb8));
}

TEST(Blend, LeavesOutWhatLiesOutside) {
  for (const auto& [x, y] : {std::array{-1, 0}, {3, 2}, {-5, 1}, {4, 1}, {1, -1}, {1, 3}}) {
    Image picture = greyPicture(PixelFormat::Rgb8);
    blend(twoPixels(x, y), picture);
    const bool second = x == -1, first = x == 3;
    EXPECT_EQ(picture == greyPicture(PixelFormat::Rgb8), !(first || second)) << x << ", " << y;
    if (second) {
      EXPECT_EQ(rgbaAt(picture, 0, 0), (Rgba{50, 50, 178, 255}));
    }
    if (first) {
      EXPECT_EQ(rgbaAt(picture, 3, 2), (Rgba{255, 0, 0, 255}));
    }
  }
}

}  // namespace
}  // namespace rotatebook::image
