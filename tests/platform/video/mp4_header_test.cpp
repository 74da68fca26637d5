#include "video/mp4_header.h"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "video/decoded_video.h"
#include "video/forged_mp4.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

using testing::BoxPatch;
using testing::forgedMp4;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr int kHeaded = 7;

std::string headedClip() {
  const auto path = testing::outputFolder() / "header.mp4";
  testing::writeClip(path, testing::smallSettings(), kHeaded);
  return testing::contentOf(path);
}

Mp4Header headerOf(const std::string& content) {
  std::istringstream file(content);
  return readMp4Header(file);
}

TEST(Mp4Header, IsThatOfTheClip) {
  const Mp4Header header = headerOf(headedClip());
  EXPECT_EQ(header.shownWidth, testing::kWidth);
  EXPECT_EQ(header.shownHeight, testing::kHeight);
  EXPECT_EQ(header.speed, 1);
  ASSERT_THAT(header.edits, SizeIs(1));
  EXPECT_DOUBLE_EQ(header.edits[0].duration, kHeaded / 60.0);
  EXPECT_EQ(header.edits[0].speed, 1);
}

TEST(Mp4Header, ReportsWhatWasForged) {
  EXPECT_EQ(headerOf(forgedMp4(headedClip(), testing::kStretched)).shownWidth, 100);
  EXPECT_EQ(headerOf(forgedMp4(headedClip(), testing::kFastMovie)).speed, 2);
  EXPECT_EQ(headerOf(forgedMp4(headedClip(), testing::kFastEdit)).edits.at(0).speed, 2);
}

TEST(Mp4Header, TakesTheFirstEditsOnly) {
  const std::string many("\x7f\xff\xff\xff", 4);
  EXPECT_THAT(headerOf(forgedMp4(headedClip(), {{"elst", 4, many}})).edits, SizeIs(16));
}

// Players may find what this program doesn't.
TEST(Mp4Header, IsUnknownWhereAnInstructionMayHide) {
  const auto isUnknown = [](const std::string& content) {
    const Mp4Header header = headerOf(content);
    return header.crop == "unknown" && header.shownWidth == 0 && header.speed == 0;
  };
  const std::string content = headedClip(), empty(
                                                "\0\0\0\x08"
                                                "free",
                                                8);
  std::string many = content;
  for (int i = 0; i < 900; ++i) many += empty;
  EXPECT_FALSE(isUnknown(many));
  for (int i = 0; i < 200; ++i) many += empty;
  EXPECT_TRUE(isUnknown(many));
  EXPECT_TRUE(isUnknown(content + std::string("\0\0\0\x08"
                                              "moov",
                                              8)));
}

TEST(Mp4Header, OfAnyBytesIsRead) {
  const std::string content = headedClip();
  for (std::size_t size = 0; size < content.size(); size += 7) headerOf(content.substr(0, size));
  for (std::size_t at = 0; at < content.size() && at < 1500; ++at) {
    for (const char value : {'\x00', '\x01', '\xff'}) {
      std::string damaged = content;
      damaged[at] = value;
      headerOf(damaged);
    }
  }
  EXPECT_THAT(headerOf(std::string(100'000, '\0')).edits, IsEmpty());
  EXPECT_EQ(headerOf("").shownWidth, 0);
}

TEST(Mp4Box, MayHaveALongSizeOrNone) {
  std::istringstream file(std::string("\0\0\0\1long\0\0\0\0\0\0\0\x14....\0\0\0\0rest......", 34));
  const auto box = mp4BoxAt(file, 0, 34);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->type, "long");
  EXPECT_EQ(box->content, 16U);
  EXPECT_EQ(box->end, 20U);
  const auto rest = mp4BoxAt(file, 20, 34);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->type, "rest");
  EXPECT_EQ(rest->end, 34U);
  EXPECT_FALSE(mp4BoxAt(file, 30, 34));
}

TEST(Mp4Box, IsNotSmallerThanItsHead) {
  std::istringstream file(std::string("\0\0\0\7tiny", 8));
  EXPECT_FALSE(mp4BoxAt(file, 0, 8));
}

}  // namespace
}  // namespace rotatebook::video
