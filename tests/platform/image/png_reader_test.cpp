#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_bytes.h"
#include "image/png_file.h"

namespace rotatebook::image {
namespace {

namespace fs = std::filesystem;
using testing::Bytes;
using testing::chunk;
using testing::ColourType;
using testing::dataChunk;
using testing::Header;
using testing::headerChunk;
using testing::joined;
using testing::pixelsOf;
using testing::pngFile;
using testing::signature;

const Bytes kRedRow = {0, 255, 0, 0};

// The message of the refusal, or "" if the bytes were read.
std::string refusalOf(const Bytes& bytes) {
  try {
    decodePng(bytes, "bad.png");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PngReader, ReadsRgb) {
  const Image picture = decodePng(pngFile({2, 2}, {0, 1, 2, 3, 4, 5, 6,  //
                                                   0, 7, 8, 9, 10, 11, 255}),
                                  "a");
  EXPECT_EQ(picture.format(), PixelFormat::Rgb8);
  EXPECT_EQ(picture.width(), 2);
  EXPECT_EQ(pixelsOf(picture), (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 255}));
}

TEST(PngReader, ReadsStraightAlpha) {
  const Image picture = decodePng(pngFile({1, 1, 8, ColourType::Rgba}, {0, 200, 100, 50, 7}), "a");
  EXPECT_EQ(picture.format(), PixelFormat::Rgba8);
  EXPECT_EQ(pixelsOf(picture), (Bytes{200, 100, 50, 7}));
}

TEST(PngReader, UndoesFilters) {
  constexpr std::uint8_t kSub = 1;
  constexpr std::uint8_t kUp = 2;
  const Image picture = decodePng(pngFile({2, 2}, {kSub, 10, 20, 30, 1, 2, 3,  //
                                                   kUp, 5, 5, 5, 250, 0, 0}),
                                  "a");
  EXPECT_EQ(pixelsOf(picture), (Bytes{10, 20, 30, 11, 22, 33, 15, 25, 35, 5, 22, 33}));
}

TEST(PngReader, ExpandsPalettes) {
  const Bytes palette = chunk("PLTE", {10, 20, 30, 40, 50, 60});
  const Header header{4, 1, 1, ColourType::Palette};
  const Image picture = decodePng(pngFile(header, {0, 0b0110'0000}, palette), "a");
  EXPECT_EQ(picture.format(), PixelFormat::Rgb8);
  EXPECT_EQ(pixelsOf(picture), (Bytes{10, 20, 30, 40, 50, 60, 40, 50, 60, 10, 20, 30}));
}

TEST(PngReader, ExpandsPalettesWithTransparency) {
  const Bytes extra = joined({chunk("PLTE", {10, 20, 30, 40, 50, 60}), chunk("tRNS", {128})});
  const Header header{2, 1, 8, ColourType::Palette};
  const Image picture = decodePng(pngFile(header, {0, 0, 1}, extra), "a");
  EXPECT_EQ(picture.format(), PixelFormat::Rgba8);
  EXPECT_EQ(pixelsOf(picture), (Bytes{10, 20, 30, 128, 40, 50, 60, 255}));
}

TEST(PngReader, ExpandsATransparentColour) {
  const Bytes extra = chunk("tRNS", {0, 1, 0, 2, 0, 3});
  const Image picture = decodePng(pngFile({2, 1}, {0, 1, 2, 3, 4, 5, 6}, extra), "a");
  EXPECT_EQ(pixelsOf(picture), (Bytes{1, 2, 3, 0, 4, 5, 6, 255}));
}

TEST(PngReader, ExpandsGrey) {
  const Header twoBits{4, 1, 2, ColourType::Grey};
  EXPECT_EQ(pixelsOf(decodePng(pngFile(twoBits, {0, 0b00'01'10'11}), "a")),
            (Bytes{0, 0, 0, 85, 85, 85, 170, 170, 170, 255, 255, 255}));
  const Header withAlpha{1, 1, 8, ColourType::GreyAlpha};
  EXPECT_EQ(pixelsOf(decodePng(pngFile(withAlpha, {0, 33, 44}), "a")), (Bytes{33, 33, 33, 44}));
}

TEST(PngReader, RoundsSixteenBits) {
  // 0x0181 / 257 = 1.498, 0xff00 / 257 = 254.0: cutting off the low byte would give 255.
  const Header header{1, 1, 16, ColourType::Rgb};
  EXPECT_EQ(pixelsOf(decodePng(pngFile(header, {0, 0x01, 0x81, 0xff, 0x00, 0x80, 0x80}), "a")),
            (Bytes{1, 254, 128}));
}

TEST(PngReader, ReadsInterlacedPictures) {
  // Adam7 of 2x2: the first pass has the left top pixel, the sixth the one beside it, the last the
  // row below.
  const Header header{2, 2, 8, ColourType::Grey, true};
  const Image picture = decodePng(pngFile(header, {0, 10, 0, 20, 0, 30, 40}), "a");
  EXPECT_EQ(pixelsOf(picture), (Bytes{10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40}));
}

TEST(PngReader, SaysNothingAboutWhatItCanRepair) {
  const Bytes wrongLength = chunk("gAMA", {1, 2, 3});
  ::testing::internal::CaptureStderr();
  const Image picture = decodePng(pngFile({1, 1}, kRedRow, wrongLength), "a");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(pixelsOf(picture), (Bytes{255, 0, 0}));
}

TEST(PngReader, RefusesWhatIsNoPng) {
  const std::string remedy = "; convert it to PNG, e.g. with ImageMagick's convert";
  EXPECT_EQ(refusalOf({}), "can't read bad.png: not a PNG" + remedy);
  EXPECT_EQ(refusalOf({0x89, 'P', 'N', 'G'}), "can't read bad.png: not a PNG" + remedy);
  EXPECT_EQ(refusalOf(Bytes(100, 'x')), "can't read bad.png: not a PNG" + remedy);
  EXPECT_EQ(refusalOf({0xff, 0xd8, 0xff, 0xe0}), "can't read bad.png: a JPEG" + remedy);
}

TEST(PngReader, RefusesEveryTruncation) {
  const Bytes whole = pngFile({2, 1}, {0, 1, 2, 3, 4, 5, 6});
  ASSERT_EQ(refusalOf(whole), "");
  for (std::size_t size = signature().size(); size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(refusalOf(part), "can't read bad.png: corrupt PNG: the file ends too early") << size;
  }
}

TEST(PngReader, RefusesEveryFlippedBit) {
  const Bytes whole = pngFile({1, 1}, kRedRow, chunk("tEXt", {'a', 0, 'b'}));
  ASSERT_EQ(refusalOf(whole), "");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes damaged = whole;
    damaged[at] ^= 0x10;
    EXPECT_NE(refusalOf(damaged), "") << "byte " << at;
  }
}

TEST(PngReader, NamesAWrongChecksum) {
  Bytes data = dataChunk(kRedRow);
  data.back() ^= 1;
  const Bytes file = joined({signature(), headerChunk({}), data, chunk("IEND", {})});
  EXPECT_EQ(refusalOf(file), "can't read bad.png: corrupt PNG: IDAT: CRC error");
}

TEST(PngReader, RefusesTooFewRows) {
  EXPECT_EQ(refusalOf(pngFile({1, 2}, kRedRow)),
            "can't read bad.png: corrupt PNG: Not enough image data");
}

TEST(PngReader, RefusesAPictureOverTheLimit) {
  EXPECT_EQ(refusalOf(pngFile({16385, 1}, kRedRow)),
            "can't read bad.png: 16385x1 pixels; the limit is 16384 a side");
  EXPECT_EQ(refusalOf(pngFile({1, 2'000'000}, kRedRow)),
            "can't read bad.png: 1x2000000 pixels; the limit is 16384 a side");
  EXPECT_EQ(refusalOf(pngFile({0, 1}, kRedRow)),
            "can't read bad.png: corrupt PNG: Invalid IHDR data");
}

TEST(PngReader, RefusesAHeaderThatClaimsMoreThanTheFileCanHold) {
  EXPECT_EQ(refusalOf(pngFile({16384, 16384}, kRedRow)),
            "can't read bad.png: corrupt PNG: 72 bytes can't hold the 16384x16384 pixels that its "
            "header claims");
}

// A file can be long without holding a picture.
TEST(PngReader, RefusesAPictureOfGigabytesWhateverTheFilesLength) {
  const Bytes padding = chunk("tEXt", Bytes(2'500'000, 'x'));
  EXPECT_EQ(refusalOf(pngFile({16384, 16384, 16, ColourType::Rgba}, kRedRow, padding)),
            "can't read bad.png: 16384x16384 pixels; the limit is 35651584 in all");
}

// A chunk may claim a gigabyte, or unpack to one.
TEST(PngReader, PassesOverChunksThatAreNoPicture) {
  Bytes claim = chunk("iCCP", {'a', 0, 0, 1, 2, 3});
  claim[0] = 0x40;
  EXPECT_EQ(refusalOf(joined({signature(), headerChunk({}), claim})),
            "can't read bad.png: corrupt PNG: the file ends too early");
  for (const char* type : {"zTXt", "iTXt", "iCCP", "sPLT", "eXIf", "tIME", "gAMA", "abCd"}) {
    const Image picture = decodePng(pngFile({1, 1}, kRedRow, chunk(type, Bytes(70, 1))), type);
    EXPECT_EQ(pixelsOf(picture), (Bytes{255, 0, 0})) << type;
  }
}

TEST(PngReader, ReadsFiles) {
  const fs::path folder = fs::path(ROTATEBOOK_TEST_OUTPUT) / "png_reader";
  fs::create_directories(folder);
  const Bytes bytes = pngFile({1, 1}, kRedRow);
  std::ofstream(folder / "a.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  EXPECT_EQ(pixelsOf(readPng(folder / "a.png")), (Bytes{255, 0, 0}));
}

std::string refusalOfFile(const fs::path& path) {
  try {
    readPng(path);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PngReader, NamesTheFileThatCanNotBeRead) {
  EXPECT_EQ(refusalOfFile("missing/a.png"), "can't read missing/a.png: No such file or directory");
  EXPECT_EQ(refusalOfFile("/"), "can't read /: Is a directory");
  EXPECT_EQ(refusalOfFile("/dev/zero"), "can't read /dev/zero: it is a device, not a file");
}

}  // namespace
}  // namespace rotatebook::image
