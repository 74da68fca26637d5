#include "video/planes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "video/bt709.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

using image::Image;
using image::PixelFormat;
using testing::barPicture;
using testing::Colour;

Image flatPicture(int width, int height, const Colour& rgb, int alpha = 255) {
  Image picture(width, height, PixelFormat::Rgba8);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = picture.row(y) + 4 * x;
      for (int i = 0; i < 3; ++i) {
        pixel[i] = static_cast<std::uint8_t>(rgb[static_cast<std::size_t>(i)]);
      }
      pixel[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return picture;
}

Image swappedRedAndBlue(Image picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      std::swap(picture.row(y)[4 * x], picture.row(y)[4 * x + 2]);
  }
  return picture;
}

TEST(Planes, AreBt709OfFlatColours) {
  constexpr double kBound = 1e-3;  // measured 4e-5
  for (const Colour& rgb :
       {Colour{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}, {0, 0, 0}, {10, 200, 90}}) {
    const Planes planes = planesOf(flatPicture(6, 4, rgb).view(), false);
    const Colour yuv = testing::yuvFromRgb(rgb);
    ASSERT_EQ(planes.y.size(), 24U);
    ASSERT_EQ(planes.u.size(), 6U);
    ASSERT_EQ(planes.v.size(), 6U);
    EXPECT_TRUE(planes.alpha.empty());
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(planes.y[4 * i], yuv[0], kBound);
      EXPECT_NEAR(planes.u[i], yuv[1], kBound);
      EXPECT_NEAR(planes.v[i], yuv[2], kBound);
    }
  }
}

TEST(Planes, TakeColourFromTheLeftOfEachPair) {
  // Red in one column of black: in half of its own pair, and in a quarter of the one to its left.
  const auto redness = [](int column) {
    Image picture = flatPicture(8, 2, {0, 0, 0});
    for (int y = 0; y < 2; ++y) picture.row(y)[4 * column] = 255;
    const Planes planes = planesOf(picture.view(), false);
    const double whole = testing::yuvFromRgb({255, 0, 0})[2] - 128;
    return std::pair{(planes.v[1] - 128) / whole, (planes.v[2] - 128) / whole};
  };
  EXPECT_NEAR(redness(4).first, 0, 1e-6);
  EXPECT_NEAR(redness(4).second, 0.5, 1e-6);
  EXPECT_NEAR(redness(3).first, 0.25, 1e-6);
  EXPECT_NEAR(redness(3).second, 0.25, 1e-6);
}

TEST(Planes, KeepAlphaIfAsked) {
  const Image picture = flatPicture(4, 2, {1, 2, 3}, 77);
  EXPECT_EQ(planesOf(picture.view(), true).alpha, std::vector<float>(8, 77));
  EXPECT_TRUE(planesOf(picture.view(), false).alpha.empty());
}

TEST(PlanesDistance, IsZeroForOneselfAndKnowsSwappedColours) {
  const Image picture = flatPicture(32, 32, {200, 100, 50});
  const Planes planes = planesOf(picture.view(), false);
  EXPECT_EQ(distance(planes, planes).rms, 0);
  EXPECT_EQ(distance(planes, planes).worstBlock, 0);
  const Planes swapped = planesOf(swappedRedAndBlue(picture).view(), false);
  EXPECT_GT(distance(planes, swapped).rms, 20);  // measured 43
}

TEST(PlanesDistance, FindsTheWorstPatch) {
  Planes a = planesOf(flatPicture(64, 48, {0, 0, 0}).view(), false);
  Planes b = a;
  for (int y = 16; y < 32; ++y) {
    std::fill_n(b.y.begin() + y * 64 + 32, 16, 16 + 30.0F);
  }
  // A patch has 256 samples of luma and 128 of colour.
  const double expected = 30 * std::sqrt(256.0 / 384);
  EXPECT_NEAR(distance(a, b).worstBlock, expected, 1e-4);
  EXPECT_NEAR(distance(a, b).rms, expected / std::sqrt(12), 1e-4);
}

TEST(PlanesDistance, CountsWhatIsLeftOfPatchesToTheirNeighbours) {
  const Planes a = planesOf(flatPicture(34, 18, {0, 0, 0}).view(), false);
  Planes b = a;
  b.y.back() += 100;  // in the second patch, which has 18 x 18 pixels, half as many colours
  EXPECT_NEAR(distance(a, b).worstBlock, 100 / std::sqrt(18 * 18 * 1.5), 1e-4);
  const Planes tiny = planesOf(flatPicture(2, 2, {0, 0, 0}).view(), false);
  EXPECT_EQ(distance(tiny, tiny).rms, 0);
}

TEST(PlanesDistance, CountsAlpha) {
  const Planes opaque = planesOf(barPicture(3).view(), false);
  Planes clear = opaque;
  clear.alpha.assign(clear.y.size(), 255);
  EXPECT_EQ(distance(opaque, clear).rms, 0);
  clear.alpha.assign(clear.y.size(), 0);
  EXPECT_GT(distance(opaque, clear).rms, 100);
}

TEST(PlanesDistance, NeedsEqualSizes) {
  const Planes a = planesOf(flatPicture(4, 2, {0, 0, 0}).view(), false);
  const Planes b = planesOf(flatPicture(2, 4, {0, 0, 0}).view(), false);
  EXPECT_THROW(distance(a, b), InputError);
}

}  // namespace
}  // namespace rotatebook::video
