// The rows of the formats, as messages and options have them.
#include "video/video_format.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::video {
namespace {

TEST(VideoFormat, IsListedInWords) {
  EXPECT_EQ(listFormats(&FormatRow::name, "and"), "mp4, webm, gif, apng, prores, hevc and av1");
  EXPECT_EQ(listFormats(&FormatRow::ending, "or"),
            ".mp4, .webm, .gif, .apng, .mov, .hevc.mp4 or .av1.mp4");
  EXPECT_EQ(listFormats(&FormatRow::title, "and", &FormatRow::holdsRecord), "MP4 and WebM");
  EXPECT_EQ(listFormats(&FormatRow::name, "or", &FormatRow::keepsTransparency),
            "webm, apng or prores");
}

TEST(VideoFormat, HasAnEndingByWhichItIsFound) {
  for (const FormatRow& row : kFormatRows) {
    EXPECT_EQ(formatOfName("a clip" + std::string(row.ending)), row.format) << row.name;
    EXPECT_EQ(nameOf(row.format), row.name);
    EXPECT_TRUE(row.ending.ends_with("." + std::string(row.muxer))) << row.name;
  }
  EXPECT_EQ(formatOfName("a.mp4.avi"), std::nullopt);
  EXPECT_EQ(formatOfName("hevc.mp4"), VideoFormat::Mp4);
}

TEST(VideoFormat, SaysWhatNamesCanEndIn) {
  EXPECT_EQ(formatOfFile("out/a.hevc.mp4"), VideoFormat::Hevc);
  const auto problem = [](const char* file) -> std::string {
    try {
      formatOfFile(file, "; or a folder");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string all =
      "; there are \".mp4\", \".webm\", \".gif\", \".apng\", \".mov\", \".hevc.mp4\" and "
      "\".av1.mp4\"; or a folder";
  EXPECT_EQ(problem("a.mp5"),
            "a.mp5: no video ends in \".mp5\"" + all + "; did you mean \".mp4\"?");
  EXPECT_EQ(problem("a"), "a: a video's name needs an ending" + all);
  EXPECT_EQ(problem("b/A.B.MP4"), "b/A.B.MP4: videos end in small letters; write b/A.B.mp4");
}

TEST(VideoFormat, NamesWhatReadsIt) {
  EXPECT_EQ(demuxers(), "mov,matroska,gif,apng");
  EXPECT_EQ(decoders(), "h264,vp9,libvpx-vp9");
}

TEST(VideoFormat, SaysWhatVerificationExpectsIfItHoldsARecord) {
  for (const FormatRow& row : kFormatRows) {
    const RecordedStream& recorded = row.recorded;
    EXPECT_EQ(row.holdsRecord, !recorded.profile.empty()) << row.name;
    EXPECT_EQ(row.holdsRecord, !recorded.decoders.empty()) << row.name;
    EXPECT_EQ(row.holdsRecord, recorded.stampBound > 0 && recorded.lengthBound > 0) << row.name;
  }
}

}  // namespace
}  // namespace rotatebook::video
