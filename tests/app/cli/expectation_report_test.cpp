#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/motion_report.h"

namespace rotatebook::cli {
namespace {

using scene::Expectation;
using scene::ExpectationResult;
using scene::Measure;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ReportLine, SaysExpectedAndMeasured) {
  const Expectation expectation{.measure = Measure::TiltDeg, .max = 1.5};
  EXPECT_EQ(reportLine({expectation, 0.02, 1.3149999, true}),
            "met      tilt_deg: expected at most 1.5; measured 0.02 to 1.315");
  EXPECT_EQ(reportLine({expectation, 0.02, 1.6, false}),
            "not met  tilt_deg: expected at most 1.5; measured 0.02 to 1.6");
}

TEST(ReportLine, NamesAllBoundsAndTheWindow) {
  const Expectation expectation{Measure::Stretch, 0.5, 2.0, 1.25, 0.75, 3, 4.5};
  EXPECT_EQ(reportLine({expectation, 0.7, 1.3, true}),
            "met      stretch from 3 s to 4.5 s: expected at least 0.5, at most 2, rises to 1.25, "
            "falls to 0.75; measured 0.7 to 1.3");
}

TEST(ReportLine, ShowsASingleNumberOnce) {
  EXPECT_EQ(reportLine({{.measure = Measure::HalfTurns, .min = 3}, 2, 2, false}),
            "not met  half_turns: expected at least 3; measured 2");
}

TEST(ReportLine, SaysThatNothingWasMeasured) {
  EXPECT_EQ(
      reportLine({{.measure = Measure::EnergyRatio, .max = 1, .from = 9}, kNan, kNan, false}),
      "not met  energy_ratio from 9 s: expected at most 1; measured nothing: the motion has no "
      "sample there");
  EXPECT_EQ(reportLine({{.measure = Measure::DivergesAt, .min = 1}, kInfinity, kInfinity, false}),
            "not met  diverges_at: expected at least 1; measured no divergence");
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

timeline::MotionSummary summaryOf(const physics::Trajectory& trajectory,
                                  const std::vector<Expectation>& expectations) {
  scene::Panel motion;
  motion.expectations = expectations;
  return timeline::summarize(motion, trajectory);
}

std::string reportOf(const timeline::MotionSummary& summary) {
  std::ostringstream out;
  reportExpectations(summary, out);
  return out.str();
}

TEST(ReportExpectations, HasALineForEach) {
  const auto summary = summaryOf(twoTurns(), {{.measure = Measure::HalfTurns, .min = 3},
                                              {.measure = Measure::HalfTurns, .min = 2}});
  EXPECT_FALSE(summary.met());
  EXPECT_EQ(reportOf(summary),
            "  not met  half_turns: expected at least 3; measured 2\n"
            "  met      half_turns: expected at least 2; measured 2\n");
}

TEST(ReportExpectations, CallsADivergenceThatNobodyExpectsUnmet) {
  physics::Trajectory trajectory = twoTurns();
  trajectory.divergedAt = 1.25;
  EXPECT_EQ(
      reportOf(summaryOf(trajectory, {{.measure = Measure::HalfTurns, .min = 2}})),
      "  not met  no divergence is expected; the motion diverges at 1.25 s, after 2 frames\n"
      "  not met  half_turns: expected at least 2; measured 2, but the motion ends at 1.25 s\n");
}

TEST(ReportExpectations, SaysWhenAMotionDivergesAsExpectedOrWithoutExpectations) {
  physics::Trajectory trajectory = twoTurns();
  trajectory.divergedAt = 1.25;
  EXPECT_EQ(reportOf(summaryOf(trajectory, {{.measure = Measure::DivergesAt, .min = 1}})),
            "  the motion diverges at 1.25 s, after 2 frames\n"
            "  met      diverges_at: expected at least 1; measured 1.25\n");
  EXPECT_EQ(reportOf(summaryOf(trajectory, {})),
            "  the motion diverges at 1.25 s, after 2 frames\n");
}

}  // namespace
}  // namespace rotatebook::cli
