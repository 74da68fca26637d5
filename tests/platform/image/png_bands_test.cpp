// The bytes that a PngWriter makes of pictures one after the other, and the pixels that come back.
#include <algorithm>
#include <filesystem>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "image/moving_picture.h"
#include "image/png_bytes.h"
#include "image/png_file.h"

namespace rotatebook::image {
namespace {

namespace fs = std::filesystem;
using testing::Bytes;
using testing::contentOf;

constexpr bool kTransparent = true;

/// A gradient with the noise of a dither, and a patch of noise whose place is `shift`.
Image framePicture(int width, int height, PixelFormat format, int shift) {
  std::mt19937 noise(5);
  Image picture(width, height, format);
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < picture.stride(); ++i) {
      picture.row(y)[i] = static_cast<std::uint8_t>(40 + y / 8 + (noise() % 8 == 0 ? 1 : 0));
    }
  }
  for (int y = shift; y < std::min(height, shift + 9); ++y) {
    for (int i = 5; i < std::min<int>(60, static_cast<int>(picture.stride())); ++i) {
      picture.row(y)[i] = static_cast<std::uint8_t>(noise());
    }
  }
  return picture;
}

class PngBandsTest : public ::testing::Test {
 protected:
  PngBandsTest() { fs::create_directories(path_.parent_path()); }

  Bytes writtenAlone(const Image& picture, bool transparent) const {
    PngWriter(transparent).write(path_, picture.view());
    return contentOf(path_);
  }
  Bytes writtenBy(PngWriter& writer, const Image& picture) const {
    writer.write(path_, picture.view());
    return contentOf(path_);
  }
  void expectPixelsBack(const Image& picture, bool transparent) const {
    writePng(path_, picture.view(), transparent);
    EXPECT_EQ(readPng(path_), picture) << picture.width() << "x" << picture.height();
  }

  const fs::path path_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "png_bands" / "a.png";
};

TEST_F(PngBandsTest, BytesDependOnThePictureAlone) {
  PngWriter writer;
  // Bands of 32 rows: the patch within one, across two, gone, back; the same again.
  for (const int shift : {0, 3, 23, 24, 31, 32, 40, 70, 70, 0, 95}) {
    const Image picture = framePicture(80, 97, PixelFormat::Rgb8, shift);
    EXPECT_EQ(writtenBy(writer, picture), writtenAlone(picture, {})) << shift;
    EXPECT_EQ(readPng(path_), picture) << shift;
  }
}

TEST_F(PngBandsTest, MarksChangeNothing) {
  for (const bool transparent : {false, true}) {
    PngWriter writer(transparent);
    testing::MovingPicture moving(200, 50);
    for (const Area& patch : testing::kPatches) {
      const Image& picture = moving.with(patch);
      ImageView unmarked = picture.view();
      unmarked.marks = nullptr;
      PngWriter(transparent).write(path_, unmarked);
      const Bytes expected = contentOf(path_);
      EXPECT_EQ(writtenBy(writer, picture), expected) << patch.x;
    }
  }
}

TEST_F(PngBandsTest, TheRowAboveABandCounts) {
  Image picture(20, 96, PixelFormat::Rgb8);
  PngWriter writer;
  writtenBy(writer, picture);
  picture.row(31)[7] = 1;  // The second band's rows stay; a filter that looks up would see it.
  EXPECT_EQ(writtenBy(writer, picture), writtenAlone(picture, {}));
  EXPECT_EQ(readPng(path_), picture);
}

TEST_F(PngBandsTest, PicturesOfOtherSizesAndFormatsMayFollow) {
  PngWriter writer(kTransparent);
  for (const PixelFormat format : {PixelFormat::Rgba8, PixelFormat::Rgb8, PixelFormat::Rgba8}) {
    for (const int height : {33, 32, 65, 1}) {
      const Image picture = framePicture(31, height, format, 4);
      EXPECT_EQ(writtenBy(writer, picture), writtenAlone(picture, kTransparent)) << height;
      EXPECT_EQ(readPng(path_), picture) << height;
    }
  }
}

TEST_F(PngBandsTest, AFailureInBetweenChangesNothing) {
  const Image first = framePicture(40, 40, PixelFormat::Rgb8, 3);
  const Image second = framePicture(40, 40, PixelFormat::Rgb8, 20);
  PngWriter writer;
  writtenBy(writer, first);
  EXPECT_ANY_THROW(writer.write(path_.parent_path() / "missing" / "a.png", second.view()));
  EXPECT_ANY_THROW(writer.write(path_, {}));
  EXPECT_EQ(writtenBy(writer, second), writtenAlone(second, {}));
  EXPECT_EQ(writtenBy(writer, first), writtenAlone(first, {}));
}

TEST_F(PngBandsTest, EverySizeComesBackExactly) {
  for (const int width : {1, 2, 3, 5, 8, 17, 64}) {
    for (const int height : {1, 2, 31, 32, 33, 70}) {
      expectPixelsBack(framePicture(width, height, PixelFormat::Rgba8, 1), kTransparent);
      expectPixelsBack(framePicture(width, height, PixelFormat::Rgb8, 1), {});
    }
  }
}

TEST_F(PngBandsTest, LeavesAlphaOutOfEveryRow) {
  const Image picture = framePicture(23, 35, PixelFormat::Rgba8, 10);
  Image opaque(23, 35, PixelFormat::Rgb8);
  for (int y = 0; y < 35; ++y) {
    for (int x = 0; x < 23; ++x) std::copy_n(picture.row(y) + 4 * x, 3, opaque.row(y) + 3 * x);
  }
  EXPECT_EQ(writtenAlone(picture, {}), writtenAlone(opaque, {}));
  EXPECT_EQ(readPng(path_), opaque);
}

TEST_F(PngBandsTest, NoiseComesBackExactly) {
  std::mt19937 generator(3);
  Image picture(301, 50, PixelFormat::Rgba8);
  for (int y = 0; y < 50; ++y) {
    for (int i = 0; i < picture.stride(); ++i) {
      picture.row(y)[i] = static_cast<std::uint8_t>(generator());
    }
  }
  expectPixelsBack(picture, kTransparent);
}

TEST_F(PngBandsTest, RunsOfEveryLengthComeBackExactly) {
  Bytes row;
  for (std::size_t run = 1; run <= 300; ++run) {
    row.insert(row.end(), run, 0);
    row.push_back(static_cast<std::uint8_t>(1 + run % 255));
  }
  row.insert(row.end(), 2000, 0);
  Image picture(static_cast<int>(row.size() / 3), 1, PixelFormat::Rgb8);
  std::copy_n(row.begin(), picture.stride(), picture.row(0));
  expectPixelsBack(picture, {});
}

}  // namespace
}  // namespace rotatebook::image
