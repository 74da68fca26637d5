#include "base/frame_rate.h"

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

TEST(FrameRate, ReadsWholeNumbersAndFractionsInLowestTerms) {
  EXPECT_EQ(parseFrameRate("60"), (FrameRate{60, 1}));
  EXPECT_EQ(parseFrameRate("30000/1001"), (FrameRate{30000, 1001}));
  EXPECT_EQ(parseFrameRate("50/2"), (FrameRate{25, 1}));
}

TEST(FrameRate, RefusesWhatIsNoRate) {
  for (const char* text : {"", "0", "-1", "29.97", "60/", "/2", "60/0", "1/2", "1001", "60 ", "6O",
                           "99999999999", "2000000/1000001"}) {
    EXPECT_FALSE(parseFrameRate(text)) << text;
  }
}

TEST(FrameRate, WritesWhatItReads) {
  EXPECT_EQ((FrameRate{60, 1}).text(), "60");
  EXPECT_EQ((FrameRate{30000, 1001}).text(), "30000/1001");
}

TEST(FrameRate, CountsFramesToTheNearest) {
  EXPECT_EQ((FrameRate{60, 1}).framesIn(2), 120);
  EXPECT_EQ((FrameRate{30000, 1001}).framesIn(1), 30);
  EXPECT_DOUBLE_EQ((FrameRate{30000, 1001}).period(), 1001.0 / 30000);
}

}  // namespace
}  // namespace rotatebook
