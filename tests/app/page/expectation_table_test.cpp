#include "page/expectation_table.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::page {
namespace {

using scene::Expectation;
using scene::Measure;

/// Returns the table's row about a motion with these tilts, and bounds on them.
Check checkOf(const std::vector<double>& tilts, Expectation bounds) {
  physics::Trajectory trajectory;
  for (const double tilt : tilts) trajectory.samples.emplace_back().tiltDeg = tilt;
  bounds.measure = Measure::TiltDeg;
  return page::checkOf(scene::check(trajectory, std::vector{bounds}).at(0));
}

std::string measured(const std::vector<double>& tilts, const Expectation& bounds) {
  return checkOf(tilts, bounds).measured;
}

TEST(CheckOf, ShowsFourDigitsAtMost) {
  EXPECT_EQ(measured({0.2425059}, {.max = 1}), "0.2425");
  EXPECT_EQ(measured({0.2425059, 131.2345678}, {.max = 180}), "0.2425 to 131.2");
  EXPECT_EQ(measured({0.9999999, 1.0000001}, {.min = 0.999999, .max = 1.000001}), "1");
  EXPECT_EQ(measured({2.99999}, {.max = 3}), "3");
}

TEST(CheckOf, ShowsMoreDigitsWhereRoundingWouldCrossABound) {
  EXPECT_EQ(measured({3.00001}, {.max = 3}), "3.00001");
  EXPECT_EQ(measured({2.999961, 4}, {.min = 3}), "2.99996 to 4");
  EXPECT_EQ(measured({0, 89.99951}, {.risesTo = 90}), "0 to 89.9995");
  EXPECT_EQ(measured({0.100004, 1}, {.fallsTo = 0.1}), "0.100004 to 1");
  EXPECT_EQ(measured({1.00000049}, {.min = 1.0000001}), "1.0000005");
  EXPECT_EQ(measured({1.0000000000000002}, {.max = 1}), "1.0000000000000002");
}

TEST(CheckOf, GivesTheVerdictOfTheNumberItself) {
  EXPECT_FALSE(checkOf({3.00001}, {.max = 3}).met);
  EXPECT_TRUE(checkOf({2.99999}, {.max = 3}).met);
}

TEST(UnexpectedDivergence, HasARoundedTime) {
  EXPECT_EQ(unexpectedDivergence(5.0 / 24).measured, "0.2083 s");
}

}  // namespace
}  // namespace rotatebook::page
