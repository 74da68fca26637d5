#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/checksum.h"
#include "image/exif.h"
#include "image/picture_bytes.h"

namespace rotatebook::image {
namespace {

using testing::Bytes;
using testing::decoded;
using testing::distance;
using testing::pixelsOf;
using testing::refusalOfPicture;
using ::testing::StartsWith;
using testing::storedPicture;

std::string sumOf(const std::string& name) {
  const Bytes pixels = pixelsOf(decoded(name));
  return checksumOf({reinterpret_cast<const char*>(pixels.data()), pixels.size()});
}

/// Returns the top left pixel of lossless.webp, which has the bytes that it was made from.
Bytes firstPixel() {
  const Bytes pixels = pixelsOf(decoded("webp/lossless.webp"));
  return {pixels.begin(), pixels.begin() + 3};
}

TEST(WebpReader, ReadsThePictureWithAndWithoutLoss) {
  constexpr double kBound = 8;  // measured 5.5
  EXPECT_EQ(firstPixel(), (Bytes{90, 150, 230}));
  EXPECT_LE(distance(decoded("webp/lossy.webp"), decoded("webp/lossless.webp")), kBound);
}

TEST(WebpReader, KeepsAlpha) {
  for (const char* name : {"webp/alpha.webp", "webp/alpha-lossless.webp"}) {
    const Image picture = decoded(name);
    ASSERT_EQ(picture.format(), PixelFormat::Rgba8) << name;
    EXPECT_EQ(picture.row(0)[3], 0);
    EXPECT_EQ(picture.row(0)[4 * 10 + 3], 110);
    EXPECT_EQ(picture.row(17)[4 * 23 + 3], 253);
  }
}

TEST(WebpReader, GivesTheSamePixelsEverywhere) {
  EXPECT_EQ(sumOf("webp/lossy.webp"), "0487deaea0942e889fa7fa614ded1d48");
  EXPECT_EQ(sumOf("webp/lossless.webp"), "55c6171e9b5efe2e18790a0bba39f97b");
  EXPECT_EQ(sumOf("webp/alpha.webp"), "2cd1b9e3f4f935de11a4e4cd31a5ac75");
}

TEST(WebpReader, TurnsPhotographsUpright) {
  EXPECT_EQ(decoded("webp/turned.webp"), upright(decoded("webp/lossless.webp"), 6));
}

TEST(WebpReader, RefusesAnimations) {
  EXPECT_EQ(refusalOfPicture(storedPicture("webp/animated.webp")),
            "can't read bad: an animated WebP; a still picture is needed, such as one of its "
            "frames: webpmux -get frame 1");
}

TEST(WebpReader, RefusesEveryTruncation) {
  for (const char* name : {"webp/lossy.webp", "webp/lossless.webp", "webp/alpha.webp",
                           "webp/alpha-lossless.webp", "webp/turned.webp"}) {
    const Bytes whole = storedPicture(name);
    for (std::size_t size = 12; size < whole.size(); ++size) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      ASSERT_THAT(refusalOfPicture(part), StartsWith("can't read bad: corrupt WebP: ")) << size;
    }
  }
}

TEST(WebpReader, OfAnyFlippedBitGivesAPictureOrRefuses) {
  for (const char* name : {"webp/lossy.webp", "webp/lossless.webp", "webp/alpha.webp"}) {
    const Bytes whole = storedPicture(name);
    int refused = 0;
    for (std::size_t at = 12; at < whole.size(); ++at) {
      Bytes damaged = whole;
      damaged[at] ^= static_cast<std::uint8_t>(1 << at % 8);
      refused += refusalOfPicture(damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 10) << name;  // measured 17, 352 and 57
  }
}

// 14 bits a side, of which all are set.
TEST(WebpReader, RefusesMorePixelsThanAClipHas) {
  Bytes file = storedPicture("webp/lossless.webp");
  for (const std::size_t at : {21, 22, 23}) file[at] = 0xff;
  file[24] |= 0x0f;
  EXPECT_EQ(refusalOfPicture(file),
            "can't read bad: 16384x16384 pixels; the limit is 35651584 in all");
}

TEST(PictureFile, OfAnotherFormatIsRefused) {
  const std::string expected =
      "can't read bad: neither PNG, JPEG nor WebP; convert it to one of them, e.g. with "
      "ImageMagick's convert";
  EXPECT_EQ(refusalOfPicture({}), expected);
  EXPECT_EQ(refusalOfPicture(Bytes(100, 'x')), expected);
  EXPECT_EQ(refusalOfPicture({'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'A', 'V', 'E'}), expected);
  EXPECT_EQ(refusalOfPicture({'G', 'I', 'F', '8', '9', 'a'}), expected);
}

TEST(PictureFile, MayBeAPng) {
  const Image picture = decodePicture(testing::pngFile({1, 1}, {0, 255, 0, 0}), "a.jpg");
  EXPECT_EQ(pixelsOf(picture), (Bytes{255, 0, 0}));
}

}  // namespace
}  // namespace rotatebook::image
