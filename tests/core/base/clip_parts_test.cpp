#include "base/clip_parts.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

using namespace std::string_view_literals;

TEST(Mp4Box, MayHaveALongSizeOrNone) {
  const auto file = "\0\0\0\1long\0\0\0\0\0\0\0\x14....\0\0\0\0rest......"sv;
  ASSERT_EQ(file.size(), 34U);
  const auto box = mp4Box(file, 0, 34);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->id, "long");
  EXPECT_EQ(box->content, 16U);
  EXPECT_EQ(box->end, 20U);
  const auto rest = mp4Box(file.substr(20), 20, 34);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->id, "rest");
  EXPECT_EQ(rest->end, 34U);
  EXPECT_FALSE(mp4Box(file.substr(30), 30, 34));
}

TEST(Mp4Box, IsNotSmallerThanItsHead) {
  EXPECT_FALSE(mp4Box("\0\0\0\7tiny"sv, 0, 8));
}

TEST(WebmElement, MayNotStateItsLength) {
  const auto element = webmElement("\x1f\x43\xb6\x75\x40\x02.."sv, 100, 200);
  ASSERT_TRUE(element);
  EXPECT_EQ(element->id, "1f43b675");
  EXPECT_EQ(element->content, 106U);
  EXPECT_EQ(element->end, 108U);
  for (const auto endless : {"\xa3\xff"sv, "\xa3\x01\xff\xff\xff\xff\xff\xff\xff"sv}) {
    ASSERT_TRUE(webmElement(endless, 0, 20));
    EXPECT_EQ(webmElement(endless, 0, 20)->end, kUnknownEnd);
  }
  EXPECT_FALSE(webmElement("\xa3\x81."sv, 20, 20)) << "beyond the end";
}

TEST(WebmElement, HasAWholeHead) {
  for (const auto bytes :
       {""sv, "\0"sv, "\0\xff"sv, "\xa3"sv, "\xa3\0"sv, "\xa3\x40"sv, "\x1f\x43"sv}) {
    EXPECT_FALSE(webmElement(bytes, 0, 20)) << bytes.size();
  }
}

}  // namespace
}  // namespace rotatebook
