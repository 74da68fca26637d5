#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/checksum.h"
#include "image/exif.h"
#include "image/picture_bytes.h"
#include "messages.h"

namespace rotatebook::image {
namespace {

using testing::Bytes;
using testing::decoded;
using testing::distance;
using testing::exifOf;
using testing::joined;
using testing::pixelsOf;
using testing::refusalOfPicture;
using ::testing::StartsWith;
using testing::storedPicture;

std::string checksumOfPixels(const Image& picture) {
  const Bytes pixels = pixelsOf(picture);
  return checksumOf({reinterpret_cast<const char*>(pixels.data()), pixels.size()});
}

/// Returns sky.jpg with `content` as its first marker, `type`.
Bytes withMarker(std::uint8_t type, const Bytes& content) {
  const Bytes file = storedPicture("jpeg/sky.jpg");
  const std::size_t size = content.size() + 2;
  return joined({{0xff, 0xd8, 0xff, type, static_cast<std::uint8_t>(size >> 8),
                  static_cast<std::uint8_t>(size)},
                 content,
                 Bytes(file.begin() + 2, file.end())});
}

Bytes photograph(int orientation) {
  return withMarker(0xe1,
                    joined({{'E', 'x', 'i', 'f', 0, 0}, exifOf("MM", 0x0112, 3, orientation)}));
}

/// Returns sky.jpg with other numbers in its header.
Bytes claiming(int width, int height) {
  Bytes file = storedPicture("jpeg/sky.jpg");
  const auto mark = std::ranges::search(file, Bytes{0xff, 0xc0}).begin();
  mark[5] = static_cast<std::uint8_t>(height >> 8);
  mark[6] = static_cast<std::uint8_t>(height);
  mark[7] = static_cast<std::uint8_t>(width >> 8);
  mark[8] = static_cast<std::uint8_t>(width);
  return file;
}

TEST(JpegReader, ReadsThePicture) {
  constexpr double kBound = 8;  // measured 6.1 and 5.2
  const Image picture = decoded("jpeg/sky.jpg"), lossless = decoded("webp/lossless.webp");
  EXPECT_EQ(picture.format(), PixelFormat::Rgb8);
  EXPECT_LE(distance(picture, lossless), kBound);
  EXPECT_LE(distance(decoded("jpeg/progressive.jpg"), lossless), kBound);
  EXPECT_GT(distance(upright(picture, 3), lossless), kBound);
}

TEST(JpegReader, ExpandsGrey) {
  const Image picture = decoded("jpeg/grey.jpg");
  EXPECT_EQ(picture.width(), 24);
  const Bytes pixels = pixelsOf(picture);
  for (std::size_t i = 0; i < pixels.size(); i += 3) {
    ASSERT_TRUE(pixels[i] == pixels[i + 1] && pixels[i] == pixels[i + 2]);
  }
  EXPECT_NE(pixels.front(), pixels.back());
}

TEST(JpegReader, GivesTheSamePixelsEverywhere) {
  EXPECT_EQ(checksumOfPixels(decoded("jpeg/sky.jpg")), "71652a40a5a141e7d73f1b6c151c5c85");
  EXPECT_EQ(checksumOfPixels(decoded("jpeg/progressive.jpg")), "e817f6dbd0868f94e507559ccc707c65");
  EXPECT_EQ(checksumOfPixels(decoded("jpeg/grey.jpg")), "4f0dcea21c7f382dbb2f785a4c72ed73");
}

// libjpeg-turbo asks each thread anew what the processor has, and the environment what to use.
TEST(JpegReader, GivesTheSamePixelsWithoutVectorCode) {
  const std::string expected = checksumOfPixels(decoded("jpeg/sky.jpg"));
  std::string plain;
  setenv("JSIMD_FORCENONE", "1", 1);
  std::thread([&] { plain = checksumOfPixels(decoded("jpeg/sky.jpg")); }).join();
  unsetenv("JSIMD_FORCENONE");
  EXPECT_EQ(plain, expected);
}

TEST(JpegReader, TurnsPhotographsUpright) {
  const Image stored = decoded("jpeg/sky.jpg");
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Image picture = decodePicture(photograph(orientation), "phone.jpg");
    EXPECT_EQ(picture, upright(stored, orientation)) << orientation;
  }
}

TEST(JpegReader, IgnoresProfilesAndTexts) {
  const Image picture = decoded("jpeg/sky.jpg");
  EXPECT_EQ(decodePicture(withMarker(0xe2, Bytes(60'000, 'x')), "a"), picture);
  EXPECT_EQ(decodePicture(withMarker(0xfe, {'h', 'i'}), "a"), picture);
  EXPECT_EQ(decodePicture(withMarker(0xe1, {'h', 't', 't', 'p'}), "a"), picture);
}

TEST(JpegReader, RefusesTheColoursOfPrinting) {
  EXPECT_EQ(refusalOfPicture(storedPicture("jpeg/cmyk.jpg")),
            "can't read bad: a JPEG of CMYK colours, which are for printing; convert it to sRGB, "
            "e.g. with ImageMagick's convert -colorspace sRGB");
}

TEST(JpegReader, RefusesEveryTruncation) {
  for (const char* name : {"jpeg/sky.jpg", "jpeg/progressive.jpg", "jpeg/grey.jpg"}) {
    const Bytes whole = storedPicture(name);
    for (std::size_t size = 3; size < whole.size(); ++size) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      ASSERT_THAT(refusalOfPicture(part), StartsWith("can't read bad: corrupt JPEG: ")) << size;
    }
  }
}

TEST(JpegReader, SaysWhatLibjpegSays) {
  Bytes whole = storedPicture("jpeg/sky.jpg");
  whole.resize(whole.size() - 2);
  EXPECT_EQ(refusalOfPicture(whole), "can't read bad: corrupt JPEG: Premature end of JPEG file");
}

TEST(JpegReader, RefusesClaims) {
  EXPECT_EQ(refusalOfPicture(claiming(16385, 30)),
            "can't read bad: 16385x30 pixels; the limit is 16384 a side");
  EXPECT_MESSAGE(refusalOfPicture(claiming(16384, 16384)));
  Bytes padded = claiming(16384, 16384);
  padded.resize(600'000);
  EXPECT_EQ(refusalOfPicture(padded),
            "can't read bad: 16384x16384 pixels; the limit is 35651584 in all");
  EXPECT_MESSAGE(refusalOfPicture(claiming(0, 30)));
}

// Each takes as long as a picture.
TEST(JpegReader, RefusesMoreScansThanAnyEncoderMakes) {
  EXPECT_EQ(refusalOfPicture(storedPicture("jpeg/scans.jpg")),
            "can't read bad: corrupt JPEG: more than 100 scans");
}

TEST(JpegReader, OfAnyFlippedBitGivesAPictureOrRefuses) {
  for (const char* name : {"jpeg/sky.jpg", "jpeg/progressive.jpg"}) {
    const Bytes whole = storedPicture(name);
    int refused = 0;
    for (std::size_t at = 3; at < whole.size(); ++at) {
      Bytes damaged = whole;
      damaged[at] ^= static_cast<std::uint8_t>(1 << at % 8);
      refused += refusalOfPicture(damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 100) << name;  // measured 146 and 508
  }
}

}  // namespace
}  // namespace rotatebook::image
