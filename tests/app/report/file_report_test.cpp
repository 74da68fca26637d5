#include "report/file_report.h"

#include <gtest/gtest.h>

namespace rotatebook::report {
namespace {

TEST(SpaceWarning, SaysHowMuchIsMissingAndWhatHelps) {
  EXPECT_EQ(spaceWarning({12.34e9, 321e6}, "out", true),
            "about 12 GB are needed in out and 321 MB are free: make room, or leave PNGs out with "
            "--no-png");
  EXPECT_EQ(spaceWarning({94'208, 0}, "out", false),
            "about 94 kB are needed in out and 0 kB are free: make room");
}

TEST(SpaceWarning, IsNoneWhereThereIsEnough) {
  EXPECT_EQ(spaceWarning({1e9, 1e9}, "out", true), "");
}

}  // namespace
}  // namespace rotatebook::report
