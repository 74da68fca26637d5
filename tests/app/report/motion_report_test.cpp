#include "report/motion_report.h"

#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::report {
namespace {

using physics::Model;

/// A motion with these errors, a sample a second. [degrees]
physics::Trajectory withErrors(const std::vector<double>& errors) {
  physics::Trajectory trajectory;
  trajectory.interval = 1;
  for (const double error : errors) {
    physics::Sample sample;
    sample.time = static_cast<double>(trajectory.samples.size());
    sample.errorDeg = error;
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

std::string distanceOf(const std::vector<double>& errors) {
  return distanceText(withErrors(errors), Model::Quaternion);
}

TEST(DistanceText, BoundsASmallErrorByOneDigit) {
  EXPECT_EQ(distanceOf({0, 1.2e-9, 1e-9}), "within 2e-9 degrees of the exact motion");
  EXPECT_EQ(distanceOf({0, 9.1e-14}), "within 1e-13 degrees of the exact motion");
  EXPECT_EQ(distanceOf({0.41}), "within 0.5 degrees of the exact motion");
  EXPECT_EQ(distanceOf({0.95}), "within 1 degree of the exact motion");
  EXPECT_EQ(distanceOf({0}), "within 0 degrees of the exact motion");
}

TEST(DistanceText, SaysHowFarAVisibleErrorWent) {
  EXPECT_EQ(distanceOf({0, 3.141, 2}), "up to 3.15 degrees from the exact motion");
  EXPECT_EQ(distanceOf({0, 10}), "up to 10 degrees from the exact motion");
}

TEST(DistanceText, SaysFromWhenOnAnErrorIsLarge) {
  EXPECT_EQ(distanceOf({0, 9, 10.5, 179.93, 4}),
            "up to 180 degrees from the exact motion; more than 10 from 2 s on");
  std::vector<double> late(1200, 0);
  late.push_back(11);
  EXPECT_EQ(distanceOf(late),
            "up to 11 degrees from the exact motion; more than 10 from 1200 s on");
}

TEST(EnergyText, BoundsASmallChangeAndGivesTheRangeOfALargeOne) {
  physics::Trajectory trajectory = withErrors({0, 0, 0});
  trajectory.samples[0].kinetic = 2;
  trajectory.samples[1].kinetic = 2 * (1 - 2.1e-9);
  trajectory.samples[2].kinetic = 2 * (1 + 1e-9);
  EXPECT_EQ(energyText(trajectory), "energy kept to 3e-9");
  trajectory.samples[1].kinetic = 1.5;
  EXPECT_EQ(energyText(trajectory), "energy 0.75 to 1 of its start");
}

TEST(DistanceText, OfTheExactModelHasNoNumber) {
  EXPECT_EQ(distanceText(withErrors({0, 5e-14}), Model::Exact),
            "the exact motion itself, in closed form");
}

}  // namespace
}  // namespace rotatebook::report
