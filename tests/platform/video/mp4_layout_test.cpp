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

}  // namespace
}  // namespace rotatebook::video
