#include "report/expectation_report.h"

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::report {
namespace {

using scene::Expectation;
using scene::ExpectationResult;
using scene::Quantity;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ReportLine, SaysExpectedAndMeasured) {
  const Expectation expectation{.quantity = Quantity::TiltDeg, .max = 1.5};
  EXPECT_EQ(reportLine({expectation, 0.02, 1.3149999, true}),
            "met    tilt_deg: expected at most 1.5; measured 0.02 to 1.315");
  EXPECT_EQ(reportLine({expectation, 0.02, 1.6, false}),
            "UNMET  tilt_deg: expected at most 1.5; measured 0.02 to 1.6");
}

TEST(ReportLine, NamesAllBoundsAndTheWindow) {
  const Expectation expectation{Quantity::Stretch, 0.5, 2.0, 1.25, 0.75, 3, 4.5};
  EXPECT_EQ(reportLine({expectation, 0.7, 1.3, true}),
            "met    stretch from 3 s to 4.5 s: expected at least 0.5, at most 2, rises to 1.25, "
            "falls to 0.75; measured 0.7 to 1.3");
}

TEST(ReportLine, ShowsASingleNumberOnce) {
  EXPECT_EQ(reportLine({{.quantity = Quantity::HalfTurns, .min = 3}, 2, 2, false}),
            "UNMET  half_turns: expected at least 3; measured 2");
}

TEST(ReportLine, SaysThatNothingWasMeasured) {
  EXPECT_EQ(
      reportLine({{.quantity = Quantity::EnergyRatio, .max = 1, .from = 9}, kNan, kNan, false}),
      "UNMET  energy_ratio from 9 s: expected at most 1; measured nothing: the motion has no "
      "sample there");
  EXPECT_EQ(reportLine({{.quantity = Quantity::DivergesAt, .min = 1}, kInfinity, kInfinity, false}),
            "UNMET  diverges_at: expected at least 1; measured no divergence");
}

/// A motion of one sample that turned over twice.
physics::Trajectory twoTurns() {
  physics::Trajectory trajectory;
  trajectory.interval = 0.5;
  trajectory.samples.resize(2);
  trajectory.samples[1].time = 0.5;
  trajectory.samples[1].halfTurns = 2;
  return trajectory;
}

TEST(ReportMotion, IsDoneIfAllIsMet) {
  std::ostringstream out;
  const std::vector<Expectation> expectations{{.quantity = Quantity::HalfTurns, .min = 2}};
  EXPECT_TRUE(reportMotion(twoTurns(), expectations, out));
  EXPECT_EQ(out.str(), "  met    half_turns: expected at least 2; measured 2\n");
}

TEST(ReportMotion, IsUnmetIfOneOfThemIs) {
  std::ostringstream out;
  const std::vector<Expectation> expectations{{.quantity = Quantity::HalfTurns, .min = 3},
                                              {.quantity = Quantity::HalfTurns, .min = 2}};
  EXPECT_FALSE(reportMotion(twoTurns(), expectations, out));
  EXPECT_EQ(out.str(),
            "  UNMET  half_turns: expected at least 3; measured 2\n"
            "  met    half_turns: expected at least 2; measured 2\n");
}

TEST(ReportMotion, DivergenceThatNobodyExpectsIsUnmet) {
  physics::Trajectory trajectory = twoTurns();
  trajectory.divergedAt = 1.25;
  const std::vector<Expectation> expectations{{.quantity = Quantity::HalfTurns, .min = 2}};
  std::ostringstream out;
  EXPECT_FALSE(reportMotion(trajectory, expectations, out));
  EXPECT_EQ(
      out.str(),
      "  UNMET  no divergence is expected; the motion diverges at 1.25 s, after 2 frames\n"
      "  UNMET  half_turns: expected at least 2; measured 2, but the motion ends at 1.25 s\n");
}

TEST(ReportMotion, DivergenceIsDoneIfItIsExpectedOrNothingIs) {
  physics::Trajectory trajectory = twoTurns();
  trajectory.divergedAt = 1.25;
  const std::vector<Expectation> expectations{{.quantity = Quantity::DivergesAt, .min = 1}};
  std::ostringstream out;
  EXPECT_TRUE(reportMotion(trajectory, expectations, out));
  EXPECT_TRUE(reportMotion(trajectory, {}, out));
  EXPECT_EQ(out.str(),
            "  the motion diverges at 1.25 s, after 2 frames\n"
            "  met    diverges_at: expected at least 1; measured 1.25\n"
            "  the motion diverges at 1.25 s, after 2 frames\n");
}

}  // namespace
}  // namespace rotatebook::report
