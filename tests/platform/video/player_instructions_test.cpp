// Instructions to players that a clip's container or stream may hold, and its quantisers.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "video/clip_reader.h"
#include "video/decoded_video.h"
#include "video/forged_mp4.h"
#include "video/forged_stream.h"
#include "video/quantiser.h"
#include "video/test_clip.h"
#include "video/webm_layout.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The bytes of a clip in `format`, encoded at `crf` if that applies.
std::string clipIn(VideoFormat format, int crf = 18, bool transparent = false) {
  VideoSettings settings = testing::smallSettings();
  settings.crf = crf;
  settings.transparent = transparent;
  const fs::path path = testing::outputFolder() / "instructions.video";
  VideoWriter writer(format, path, settings);
  for (int n = 0; n < 3; ++n) writer.write(testing::barPicture(n).view());
  writer.finish();
  return testing::contentOf(path);
}

ClipReader readerOf(const std::string& content) {
  const fs::path path = testing::outputFolder() / "instructions_forged.video";
  std::ofstream(path, std::ios::binary) << content;
  return ClipReader(path);
}

PictureFacts firstPictureOf(ClipReader reader) {
  EXPECT_TRUE(reader.next());
  return reader.pictureFacts();
}

std::string replaced(std::string content, const std::string& what, const std::string& with) {
  const std::size_t at = content.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return content.replace(at, with.size(), with);
}

TEST(Quantiser, OfAClipIsThatOfItsStream) {
  const auto quantiserOf = [](const std::string& content) {
    return firstPictureOf(readerOf(content)).quantiser;
  };
  const double fine = quantiserOf(clipIn(VideoFormat::Mp4, 1)).value();
  const double coarse = quantiserOf(clipIn(VideoFormat::Mp4, 40)).value();
  EXPECT_LT(fine, 10);
  EXPECT_GT(coarse, 30);
  const double webm = quantiserOf(clipIn(VideoFormat::WebM)).value();
  EXPECT_NEAR(webm, 14.3, 5);  // measured 14.3
  // The same colours, and alpha beside them.
  EXPECT_NEAR(quantiserOf(clipIn(VideoFormat::WebM, 18, true)).value(), webm, 5);
}

// VP9's table has AC steps of 8, 102, 155, 412 and 1828 eighths there.
TEST(Quantiser, OfVp9HasTheSameStepInH264) {
  EXPECT_NEAR(quantiserOfVp9(1), 6 * std::log2(8 / 5.0), 1e-9);
  EXPECT_NEAR(quantiserOfVp9(95), 6 * std::log2(102 / 5.0), 1e-9);
  EXPECT_LT(quantiserOfVp9(-5), 4);
  EXPECT_NEAR(quantiserOfVp9(255), 51, 1e-9);
  EXPECT_NEAR(quantiserOfVp9(1000), 51, 1e-9);
}

TEST(PictureFacts, OfAClipAskNothingOfPlayers) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const ClipReader reader = readerOf(clipIn(format));
    EXPECT_EQ(reader.facts().scan, "progressive");
    const PictureFacts picture = firstPictureOf(readerOf(clipIn(format)));
    EXPECT_FALSE(picture.interlaced);
    EXPECT_THAT(picture.messages, IsEmpty());
    EXPECT_EQ(picture.crop[0] + picture.crop[1] + picture.crop[2] + picture.crop[3], 0);
  }
}

TEST(PictureFacts, ReportFieldsAndMessages) {
  const fs::path path = testing::outputFolder() / "instructions_stream.mp4";
  testing::writeForgedStream(path, "tff=1", "null");
  EXPECT_EQ(ClipReader(path).facts().scan, "interlaced");
  EXPECT_TRUE(firstPictureOf(ClipReader(path)).interlaced);
  testing::writeForgedStream(path, "bframes=0",
                             "h264_metadata=display_orientation=insert:rotate=180");
  EXPECT_THAT(firstPictureOf(ClipReader(path)).messages, HasSubstr("displaymatrix"));
  testing::writeForgedStream(path, "bframes=0", "null");
  EXPECT_THAT(firstPictureOf(ClipReader(path)).messages, IsEmpty());
}

TEST(PictureFacts, ReportTagsThatChangeInMidClip) {
  const fs::path path = testing::outputFolder() / "instructions_tags.mp4";
  const auto lastPictureOf = [&](const std::string& laterTags) {
    testing::writeForgedStream(path, "keyint=2:bframes=0", "null",
                               "h264_metadata=" + laterTags + ",dump_extra=freq=keyframe");
    ClipReader reader(path);
    EXPECT_TRUE(reader.next());
    EXPECT_EQ(reader.pictureFacts().pixelShape, "1:1");
    EXPECT_EQ(reader.pictureFacts().colours.primaries, "bt709");
    while (reader.next()) {
    }
    return reader.pictureFacts();
  };
  EXPECT_EQ(lastPictureOf("sample_aspect_ratio=1/4").pixelShape, "1:4");
  const ColourTags colours =
      lastPictureOf("colour_primaries=9:transfer_characteristics=16:matrix_coefficients=9").colours;
  EXPECT_EQ(colours.primaries, "bt2020");
  EXPECT_EQ(colours.transfer, "smpte2084");
  EXPECT_EQ(colours.matrix, "bt2020nc");
  EXPECT_EQ(lastPictureOf("video_full_range_flag=1").colours.range, "pc");
}

TEST(PictureFacts, ReportAlpha) {
  const std::string opaque = clipIn(VideoFormat::WebM);
  EXPECT_FALSE(firstPictureOf(readerOf(opaque)).alpha);
  EXPECT_TRUE(firstPictureOf(readerOf(clipIn(VideoFormat::WebM, 18, true))).alpha);
  // Stated in place of the colours, which then are empty space.
  const PictureFacts stated =
      firstPictureOf(readerOf(replaced(opaque, "\x55\xb0\x98", "\x53\xc0\x81\x01\xec\x95")));
  EXPECT_TRUE(stated.alpha);
  EXPECT_TRUE(stated.quantiser);
}

TEST(ClipFacts, ReportFieldsOfTheContainer) {
  const std::string mp4 = clipIn(VideoFormat::Mp4);
  EXPECT_EQ(readerOf(testing::forgedMp4(mp4, testing::kFields)).facts().scan, "interlaced");
}

TEST(ClipFacts, OfAnotherCodecAreRefusedByItsName) {
  std::string other = clipIn(VideoFormat::Mp4);
  // The brand, then the description.
  for (int i = 0; i < 2; ++i) other = replaced(other, "avc1", "hvc1");
  try {
    readerOf(replaced(other, "avcC", "hvcC"));
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

TEST(WebmLayout, OfAnyBytesIsRefused) {
  const std::string content = clipIn(VideoFormat::WebM);
  const auto differenceOf = [](const std::string& bytes) {
    std::istringstream file(bytes);
    return webmDifference(file, {.width = testing::kWidth, .height = testing::kHeight}, {});
  };
  EXPECT_NE(differenceOf(""), "");
  EXPECT_NE(differenceOf(std::string(100'000, '\x01')), "");
  for (std::size_t size = 0; size < content.size(); size += 7) {
    EXPECT_NE(differenceOf(content.substr(0, size)), "");
  }
  for (std::size_t at = 0; at < content.size() && at < 600; ++at) {
    for (const char value : {'\x00', '\x01', '\xff'}) {
      std::string damaged = content;
      damaged[at] = value;
      differenceOf(damaged);
    }
  }
}

// Tracks may be nested in tracks as deep as the file is long.
TEST(WebmLayout, OfNestedTracksIsRefused) {
  std::string content = "\x18\x53\x80\x67\xff\x16\x54\xae\x6b\xff\xae\xff\xe0\xff";
  for (int i = 0; i < 100'000; ++i) content += "\xae\xff";
  std::istringstream file(content);
  EXPECT_NE(webmDifference(file, {}, {}), "");
}

}  // namespace
}  // namespace rotatebook::video
