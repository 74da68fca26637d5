#include "video/mp4_layout.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "video/decoded_video.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

constexpr int kHeaded = 7;

std::string headedClip() {
  const auto path = testing::outputFolder() / "header.mp4";
  testing::writeClip(path, testing::smallSettings(), kHeaded);
  return testing::contentOf(path);
}

std::string differenceOf(const std::string& content) {
  std::istringstream file(content);
  return mp4Difference(file, {.width = testing::kWidth, .height = testing::kHeight}, {});
}

TEST(Mp4Layout, OfAnyBytesIsRefused) {
  const std::string content = headedClip();
  for (std::size_t size = 0; size < content.size(); size += 7) {
    EXPECT_NE(differenceOf(content.substr(0, size)), "");
  }
  for (std::size_t at = 0; at < content.size() && at < 1500; ++at) {
    for (const char value : {'\x00', '\x01', '\xff'}) {
      std::string damaged = content;
      damaged[at] = value;
      differenceOf(damaged);
    }
  }
  EXPECT_NE(differenceOf(std::string(100'000, '\0')), "");
  EXPECT_EQ(differenceOf(""), "the file lacks ftyp");
}

TEST(Mp4Box, MayHaveALongSizeOrNone) {
  std::istringstream file(std::string("\0\0\0\1long\0\0\0\0\0\0\0\x14....\0\0\0\0rest......", 34));
  const auto box = mp4BoxAt(file, 0, 34);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->id, "long");
  EXPECT_EQ(box->content, 16U);
  EXPECT_EQ(box->end, 20U);
  const auto rest = mp4BoxAt(file, 20, 34);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->id, "rest");
  EXPECT_EQ(rest->end, 34U);
  EXPECT_FALSE(mp4BoxAt(file, 30, 34));
}

TEST(Mp4Box, IsNotSmallerThanItsHead) {
  std::istringstream file(std::string("\0\0\0\7tiny", 8));
  EXPECT_FALSE(mp4BoxAt(file, 0, 8));
}

}  // namespace
}  // namespace rotatebook::video
