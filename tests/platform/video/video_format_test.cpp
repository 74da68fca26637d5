// The rows of the formats, as messages and options have them.
#include "video/video_format.h"

#include <gtest/gtest.h>

namespace rotatebook::video {
namespace {

TEST(VideoFormat, IsListedInWords) {
  EXPECT_EQ(listFormats(&FormatRow::name, "and"), "mp4, webm, gif and apng");
  EXPECT_EQ(listFormats(&FormatRow::ending, "or"), ".mp4, .webm, .gif or .apng");
  EXPECT_EQ(listFormats(&FormatRow::title, "and", &FormatRow::holdsRecord), "MP4 and WebM");
  EXPECT_EQ(listFormats(&FormatRow::name, "or", &FormatRow::keepsTransparency), "webm or apng");
}

TEST(VideoFormat, HasAnEndingThatIsItsName) {
  for (const FormatRow& row : kFormatRows) {
    EXPECT_EQ(row.ending, "." + std::string(row.name));
    EXPECT_EQ(nameOf(row.format), row.name);
  }
}

}  // namespace
}  // namespace rotatebook::video
