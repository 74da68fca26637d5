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

}  // namespace
}  // namespace rotatebook::cli
