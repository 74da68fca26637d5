#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_bytes.h"
#include "image/png_file.h"

namespace rotatebook::image {
namespace {

namespace fs = std::filesystem;
using testing::Bytes;
using testing::contentOf;
using testing::pixelsOf;

const Bytes kTwoByTwo = {255, 0, 0, 0, 254, 0, 0, 0, 253, 1, 2, 3};

class PngWriterTest : public ::testing::Test {
 protected:
  PngWriterTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  Image writtenAndRead(ImageView view, bool transparent = false) const {
    writePng(folder_ / "a.png", view, transparent);
    return readPng(folder_ / "a.png");
  }

  std::string refusalOf(const fs::path& path, ImageView view) const {
    try {
      writePng(path, view);
      return "";
    } catch (const MachineError& error) {
      return error.what();
    }
  }

  std::ptrdiff_t filesInFolder() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const fs::path folder_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "png_writer";
};

TEST_F(PngWriterTest, KeepsEveryPixel) {
  const Image read = writtenAndRead({kTwoByTwo.data(), 2, 2, 6, PixelFormat::Rgb8});
  EXPECT_EQ(read.format(), PixelFormat::Rgb8);
  EXPECT_EQ(pixelsOf(read), kTwoByTwo);
}

TEST_F(PngWriterTest, KeepsAlphaIfAsked) {
  Image picture(3, 2, PixelFormat::Rgba8);
  for (int i = 0; i < 24; ++i) picture.row(0)[i] = static_cast<std::uint8_t>(i * 37);
  EXPECT_EQ(writtenAndRead(picture.view(), true), picture);
  EXPECT_EQ(writtenAndRead(picture.view()).format(), PixelFormat::Rgb8);
  const Image opaque(3, 2, PixelFormat::Rgb8);
  EXPECT_EQ(writtenAndRead(opaque.view(), true), opaque);
}

TEST_F(PngWriterTest, LeavesAlphaOut) {
  const Bytes rgba = {9, 8, 7, 0, 6, 5, 4, 200};
  const Image read = writtenAndRead({rgba.data(), 2, 1, 8, PixelFormat::Rgba8});
  EXPECT_EQ(read.format(), PixelFormat::Rgb8);
  EXPECT_EQ(pixelsOf(read), (Bytes{9, 8, 7, 6, 5, 4}));
}

TEST_F(PngWriterTest, TakesBottomUpRows) {
  const Image read = writtenAndRead({kTwoByTwo.data() + 6, 2, 2, -6, PixelFormat::Rgb8});
  EXPECT_EQ(pixelsOf(read), (Bytes{0, 0, 253, 1, 2, 3, 255, 0, 0, 0, 254, 0}));
}

TEST_F(PngWriterTest, SkipsPaddingBehindRows) {
  const Bytes padded = {1, 2, 3, 99, 99, 4, 5, 6, 99, 99};
  const Image read = writtenAndRead({padded.data(), 1, 2, 5, PixelFormat::Rgb8});
  EXPECT_EQ(pixelsOf(read), (Bytes{1, 2, 3, 4, 5, 6}));
}

TEST_F(PngWriterTest, WritesEightBitRgbMarkedAsSrgb) {
  writtenAndRead({kTwoByTwo.data(), 2, 2, 6, PixelFormat::Rgb8});
  const Bytes file = contentOf(folder_ / "a.png");
  EXPECT_THAT(testing::chunkTypes(file),
              ::testing::ElementsAre("IHDR", "sRGB", "IDAT", "tEXt", "IEND"));
  const Bytes head = testing::joined({testing::signature(), testing::headerChunk({2, 2})});
  EXPECT_EQ(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(head.size())), head);
}

TEST_F(PngWriterTest, MarksPicturesAsTheProgramsButNoFrames) {
  const ImageView picture{kTwoByTwo.data(), 2, 2, 6, PixelFormat::Rgb8};
  writePng(folder_ / "a.png", picture);
  PngWriter().write(folder_ / "frame.png", picture);
  const Bytes frame = contentOf(folder_ / "frame.png");
  const std::string text("Software\0rotatebook", 19);
  const Bytes end = testing::chunk("IEND", {});
  EXPECT_EQ(contentOf(folder_ / "a.png"),
            testing::joined({Bytes(frame.begin(), frame.end() - std::ssize(end)),
                             testing::chunk("tEXt", Bytes(text.begin(), text.end())), end}));
}

// A ramp with some texture, of several bands.
Image texturedPicture() {
  Image picture(200, 100, PixelFormat::Rgb8);
  for (int y = 0; y < picture.height(); ++y) {
    for (int i = 0; i < picture.stride(); ++i) {
      picture.row(y)[i] = static_cast<std::uint8_t>(i / 3 + y + (i * y) % 13);
    }
  }
  return picture;
}

TEST_F(PngWriterTest, GivesTheSameBytesAgain) {
  const Image picture = texturedPicture();
  writePng(folder_ / "a.png", picture.view());
  writePng(folder_ / "b.png", picture.view());
  EXPECT_EQ(contentOf(folder_ / "a.png"), contentOf(folder_ / "b.png"));
}

TEST_F(PngWriterTest, NamesAFullDisk) {
  const fs::path path = folder_ / "full.png";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit little{10, before.rlim_max};  // [bytes]
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &little);
  const std::string refusal = refusalOf(path, texturedPicture().view());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(refusal, "can't write " + path.string() + ": File too large");
  EXPECT_EQ(filesInFolder(), 0);
}

TEST_F(PngWriterTest, NamesAMissingFolder) {
  const fs::path path = folder_ / "missing" / "a.png";
  EXPECT_EQ(refusalOf(path, texturedPicture().view()),
            "can't write " + path.string() + ": No such file or directory");
}

TEST_F(PngWriterTest, RefusesAnEmptyPictureAndLeavesTheOldFile) {
  writtenAndRead({kTwoByTwo.data(), 2, 2, 6, PixelFormat::Rgb8});
  EXPECT_EQ(refusalOf(folder_ / "a.png", {}),
            "can't write " + (folder_ / "a.png").string() + ": libpng: Invalid IHDR data");
  EXPECT_EQ(pixelsOf(readPng(folder_ / "a.png")), kTwoByTwo);
  EXPECT_EQ(filesInFolder(), 1);
}

}  // namespace
}  // namespace rotatebook::image
