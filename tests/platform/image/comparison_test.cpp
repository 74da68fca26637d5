#include "image/comparison.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Two rows of two pixels.
const Bytes kBase = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120};
// Differs by (0, 0, 3), (0, 0, 0), (1, 2, 0) and (0, -50, 0).
const Bytes kOther = {10, 20, 33, 40, 50, 60, 71, 82, 90, 100, 60, 120};

ImageView twoByTwo(const Bytes& bytes) {
  return {bytes.data(), 2, 2, 6, PixelFormat::Rgb8};
}

TEST(Compare, FindsEqualPicturesEqual) {
  const Comparison result = compare(twoByTwo(kBase), twoByTwo(kBase), {});
  EXPECT_TRUE(result.same);
  EXPECT_EQ(result.largest, 0);
  EXPECT_EQ(result.mean, 0);
  EXPECT_EQ(result.differingPixels, 0);
}

TEST(Compare, CountsByHand) {
  const Comparison result = compare(twoByTwo(kBase), twoByTwo(kOther), {});
  EXPECT_FALSE(result.same);
  EXPECT_EQ(result.largest, 50);
  EXPECT_DOUBLE_EQ(result.mean, (3 + 1 + 2 + 50) / 12.0);
  EXPECT_EQ(result.differingPixels, 3);
  EXPECT_DOUBLE_EQ(result.differingPercent, 75);
}

TEST(Compare, AllowsDifferencesUpToTheLargest) {
  EXPECT_EQ(compare(twoByTwo(kBase), twoByTwo(kOther), {2}).differingPixels, 2);
  EXPECT_EQ(compare(twoByTwo(kBase), twoByTwo(kOther), {3}).differingPixels, 1);
  EXPECT_FALSE(compare(twoByTwo(kBase), twoByTwo(kOther), {49}).same);
  EXPECT_TRUE(compare(twoByTwo(kBase), twoByTwo(kOther), {50}).same);
}

TEST(Compare, AllowsAShareOfThePixels) {
  EXPECT_FALSE(compare(twoByTwo(kBase), twoByTwo(kOther), {3, 24.9}).same);
  EXPECT_TRUE(compare(twoByTwo(kBase), twoByTwo(kOther), {3, 25}).same);
  EXPECT_TRUE(compare(twoByTwo(kOther), twoByTwo(kBase), {3, 25}).same);
}

TEST(Compare, IgnoresAlphaAndMixesFormats) {
  const Bytes rgba = {10, 20, 30, 0, 40, 50, 60, 255};
  const Bytes rgb = {10, 20, 30, 40, 50, 61};
  const Comparison result = compare({rgba.data(), 2, 1, 8, PixelFormat::Rgba8},
                                    {rgb.data(), 2, 1, 6, PixelFormat::Rgb8}, {});
  EXPECT_EQ(result.differingPixels, 1);
  EXPECT_EQ(result.largest, 1);
}

TEST(Compare, TakesBottomUpRows) {
  const Bytes flipped = {70, 80, 90, 100, 110, 120, 10, 20, 30, 40, 50, 60};
  const ImageView bottomUp{flipped.data() + 6, 2, 2, -6, PixelFormat::Rgb8};
  EXPECT_TRUE(compare(twoByTwo(kBase), bottomUp, {}).same);
  EXPECT_FALSE(compare(twoByTwo(kBase), twoByTwo(flipped), {}).same);
}

TEST(Compare, FindsEmptyPicturesEqual) {
  const Comparison result = compare({}, {}, {});
  EXPECT_TRUE(result.same);
  EXPECT_EQ(result.differingPercent, 0);
}

// Calls `action`, which must throw an InputError, and returns its message.
template <typename Action>
std::string refusalOf(Action action) {
  try {
    action();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Compare, RefusesDifferentSizes) {
  const ImageView fourByOne{kBase.data(), 4, 1, 12, PixelFormat::Rgb8};
  const std::string words = "can't compare pictures of different sizes: 2x2 and 4x1";
  EXPECT_EQ(refusalOf([&] { compare(twoByTwo(kBase), fourByOne, {}); }), words);
  EXPECT_EQ(refusalOf([&] { differenceImage(twoByTwo(kBase), fourByOne); }), words);
}

TEST(DifferenceImage, AmplifiesAndClamps) {
  const Image picture = differenceImage(twoByTwo(kBase), twoByTwo(kOther));
  EXPECT_EQ(picture.format(), PixelFormat::Rgb8);
  const Bytes pixels(picture.row(0), picture.row(0) + 12);
  EXPECT_EQ(pixels, (Bytes{0, 0, 48, 0, 0, 0, 16, 32, 0, 0, 255, 0}));
}

TEST(DifferenceImage, TakesAnyGain) {
  const Image picture = differenceImage(twoByTwo(kBase), twoByTwo(kOther), 1);
  EXPECT_EQ(picture.row(0)[2], 3);
  EXPECT_EQ(picture.row(1)[4], 50);
}

}  // namespace
}  // namespace rotatebook::image
