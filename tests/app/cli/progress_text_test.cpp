#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "cli/progress_line.h"

namespace rotatebook::cli {
namespace {

TEST(ProgressText, ShowsFramesRateAndTimeLeft) {
  EXPECT_EQ(progressText(126, 300, 38.12),
            "[######..........]  42 %  126/300 frames, 38.1 frames/s, 5 s left");
}

TEST(ProgressText, LeavesOutWhatIsNotKnownYet) {
  EXPECT_EQ(progressText(0, 300, 0), "[................]   0 %  0/300 frames");
}

TEST(ProgressText, IsFullAtTheEnd) {
  EXPECT_EQ(progressText(300, 300, 40),
            "[################] 100 %  300/300 frames, 40.0 frames/s, 0 s left");
}

TEST(ProgressText, BearsAnEmptyClip) {
  EXPECT_EQ(progressText(0, 0, 0), "[................]   0 %  0/0 frames");
}

TEST(ProgressText, HasRoomForLongClips) {
  EXPECT_EQ(progressText(999'999'999'999, 1'000'000'000'000, 0.1),
            "[###############.] 100 %  999999999999/1000000000000 frames, 0.1 frames/s, "
            "10 s left");
}

TEST(ProgressText, CountsWhateverIsDone) {
  EXPECT_EQ(progressText(3, 12, 1.5, "runs"),
            "[####............]  25 %  3/12 runs, 1.5 runs/s, 6 s left");
}

TEST(ProgressText, ShrinksAndKeepsTheTimeLeft) {
  const auto in = [](std::size_t columns) {
    return progressText(126, 300, 38.12, "frames", columns);
  };
  EXPECT_EQ(in(66), "[######..........]  42 %  126/300 frames, 38.1 frames/s, 5 s left");
  EXPECT_EQ(in(60), "[######.........]  42 %  126/300 frames, 5 s left");
  EXPECT_EQ(in(49), "[#####.......]  42 %  126/300 frames, 5 s left");
  EXPECT_EQ(in(30), "[##.....]  42 %, 5 s left");
  EXPECT_EQ(in(20), "[..]  42 %, 5 s left");
  EXPECT_EQ(in(18), " 42 %, 5 s left");
  EXPECT_EQ(in(14), " 42 %");
  EXPECT_EQ(in(3), " 42");
  EXPECT_EQ(in(0), "");
}

TEST(ProgressText, FitsAndItsBarShrinksCellByCell) {
  for (const double rate : {0.0, 38.12, 1e5}) {
    std::ptrdiff_t last = 16;
    for (std::size_t columns = 90; columns > 0; --columns) {
      const std::string text = progressText(126, 300, rate, "frames", columns);
      const std::ptrdiff_t cells = std::ranges::count(text, '#') + std::ranges::count(text, '.') -
                                   (text.find("/s") == text.npos ? 0 : 1);
      EXPECT_LE(text.size(), columns);
      EXPECT_LE(cells, last) << text;
      EXPECT_GE(cells, last - 1) << text;
      last = cells;
    }
    EXPECT_EQ(last, 0);
  }
}

TEST(ProgressText, IsJson) {
  EXPECT_EQ(progressJson("two \"scenes\"", 126, 300, 38.123456, "frames"),
            R"({"progress":"two \"scenes\"","done":126,"total":300,"unit":"frames",)"
            R"("per_s":38.12,"left_s":4.564})");
  EXPECT_EQ(progressJson("a", 0, 3, 0, "runs"),
            R"({"progress":"a","done":0,"total":3,"unit":"runs","per_s":null,"left_s":null})");
}

}  // namespace
}  // namespace rotatebook::cli
