#include "page/captions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(WebVtt, LastsUntilTheNextEventOrTheEnd) {
  EXPECT_EQ(webVtt({{10, "a"}, {20, "b"}, {70, "c"}}, {10, 1}, 80),
            "WEBVTT\n\n00:00:01.000 --> 00:00:01.950 line:0\na\n\n00:00:02.000 --> 00:00:05.000 "
            "line:0\nb\n"
            "\n00:00:07.000 --> 00:00:07.950 line:0\nc\n");
}

TEST(WebVtt, ShowsTheLastFrameForAWhile) {
  EXPECT_THAT(webVtt({{79, "end"}}, {10, 1}, 80),
              HasSubstr("00:00:07.200 --> 00:00:08.000 line:0\nend\n"));
}

TEST(WebVtt, HoldsWordsAsWords) {
  EXPECT_THAT(webVtt({{0, "a --> <b> & c"}}, {10, 1}, 80),
              AllOf(HasSubstr("a --&gt; &lt;b&gt; &amp; c"), Not(HasSubstr("<b>"))));
  EXPECT_EQ(webVtt({}, {10, 1}, 80), "WEBVTT\n");
}

}  // namespace
}  // namespace rotatebook::page
