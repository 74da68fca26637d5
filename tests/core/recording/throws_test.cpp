// The throws of a recording, found by its rates alone.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recording/refusal.h"
#include "recording/toss.h"
#include "recording/tosses.h"

namespace rotatebook::recording {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Returns a recording of `count` tosses, one after the other, without an accelerometer. Between
/// them a hand turns the body, smoothly and about axes that change.
InertialRecording several(int count) {
  Tosses tosses;
  InertialRecording all;
  double zero = 0;
  for (int i = 0; i < count; ++i) {
    const InertialRecording one = tosses.toss({9 + 0.3 * i, 1.5, -2}, tosses.axes());
    for (InertialReading reading : one.readings) {
      reading.rate.time += zero - one.readings.front().rate.time;
      all.readings.push_back(reading);
    }
    zero = all.readings.back().rate.time + kInterval;
    for (int k = 0; k < 120; ++k, zero += kInterval) {
      const double t = k * kInterval;
      all.readings.push_back(
          {{zero, {4 * std::sin(3 * t), 3 * std::cos(5 * t + 1), 2 * std::sin(7 * t * t)}}});
    }
  }
  return all;
}

TEST(Throws, AreFoundByTheRatesAlone) {
  const InertialRecording recording = several(4);
  std::vector<Throw> accepted;
  for (const Throw& one : findThrows(recording, "t.csv", {})) {
    if (one.fit) accepted.push_back(one);
  }
  ASSERT_EQ(accepted.size(), 4U);
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    const double start = static_cast<double>(i) * 3.41 + 1.2;  // [s]
    EXPECT_NEAR(accepted[i].from, start, 0.06);
    EXPECT_NEAR(accepted[i].to, start + 0.8, 0.06);
    EXPECT_NEAR(accepted[i].fit->ratios[0].value, kBook[1] / kBook[2], 2e-3);
    EXPECT_NEAR(accepted[i].fit->ratios[1].value, kBook[0] / kBook[2], 2e-3);
  }
}

TEST(Throws, AreTakenWhereThereIsOne) {
  const TossFit fit = fitToss(several(1), "t.csv", {});
  EXPECT_NEAR(fit.from, 1.2, 0.06);
  EXPECT_NEAR(fit.ratios[0].value, kBook[1] / kBook[2], 2e-3);
}

TEST(Throws, AreNamedWhereThereAreSeveral) {
  EXPECT_THAT(refusalOf([] { fitToss(several(2), "t.csv", {}); }),
              AllOf(HasSubstr("t.csv: 2 throws, at 1.2"), HasSubstr(" to 1.9"), HasSubstr(" s; "),
                    HasSubstr("state one with --from and --to")));
}

TEST(Throws, AreNamedByTimesThatTellThemApart) {
  EXPECT_EQ(timeText(1.21999999), "1.22");
  EXPECT_EQ(timeText(-281.57004), "-281.57");
  EXPECT_EQ(timeText(1727600000.123456), "1727600000.1235");
  EXPECT_EQ(timeText(0), "0");
}

TEST(Throws, ArentSeenInARest) {
  InertialRecording recording = several(1);
  recording.readings.resize(100);
  EXPECT_TRUE(findThrows(recording, "t.csv", {}).empty());
  EXPECT_THAT(refusalOf([&] { fitToss(recording, "t.csv", {}); }),
              HasSubstr("no throw was found in the rates alone"));
}

}  // namespace
}  // namespace rotatebook::recording
