#include "physics/measure/flip_interval.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "physics/scenarios.h"
#include "rigid/exact_motion.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

constexpr double kInterpolationBound = 1e-5;  // of the interval; measured 2e-6
constexpr double kLargeTiltBound = 1e-4;      // of the law at a tilt of 0.1; measured 2.5e-5
constexpr double kTinyTiltBound = 1e-7;       // of the law at a tilt of 1e-4; measured 2e-9

const Vector3d kMoments = body::Cuboid{}.solidInertia();  // x is the middle axis, y the smallest

MotionSettings tilted(double angle, int axis) {
  MotionSettings settings = spinning(Model::Exact, {kSpinRate, 0, 0}, 1.0 / 60);
  settings.initial.tilt = Tilt{angle, axis};
  return settings;
}

double exactInterval(const MotionSettings& settings) {
  return rigid::ExactMotion(modelInertia(settings).moments, initialAngularVelocity(settings))
      .flipInterval();
}

double lawOf(const MotionSettings& settings) {
  return asymptoticFlipInterval(modelInertia(settings), initialAngularVelocity(settings));
}

double deviation(double angle, int axis) {
  const MotionSettings settings = tilted(angle, axis);
  return exactInterval(settings) / lawOf(settings) - 1;
}

TEST(FlipTimes, AreThoseOfTheExactMotion) {
  for (const double angle : {0.1, 0.001}) {
    const MotionSettings settings = tilted(angle, 2);
    const auto times = flipTimes(simulate(settings, 1200), modelInertia(settings));
    const double interval = exactInterval(settings);
    ASSERT_GE(times.size(), 4U);
    EXPECT_NEAR(times.front(), interval / 2, kInterpolationBound * interval);
    EXPECT_NEAR(meanInterval(times), interval, kInterpolationBound * interval);
  }
}

TEST(FlipTimes, AreNoneOfASpinAboutAnotherAxis) {
  const MotionSettings settings = spinning(Model::Exact, {0.01, kSpinRate, 0.01}, 1.0 / 60);
  rigid::PrincipalAxes other = modelInertia(settings);
  std::swap(other.moments[0], other.moments[1]);  // so that y is called the middle axis
  EXPECT_TRUE(flipTimes(simulate(settings, 600), other).empty());
}

TEST(FlipTimes, FollowTheBodysOwnAxes) {
  MotionSettings settings = tilted(0.05, 2);
  const auto plain = flipTimes(simulate(settings, 600), modelInertia(settings));
  // Describe body and spin along axes that are turned by an eighth of a turn about z.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(std::atan(1.0), Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d velocity = initialAngularVelocity(settings);
  settings.initial = {InitialSpin::Kind::AngularVelocity, turn * velocity};
  settings.inertia = turn * kMoments.asDiagonal() * turn.transpose();
  const auto turned = flipTimes(simulate(settings, 600), modelInertia(settings));
  ASSERT_EQ(plain.size(), turned.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(turned[i], plain[i], 1e-9);
}

TEST(MeanInterval, NeedsTwoFlips) {
  EXPECT_TRUE(std::isnan(meanInterval({})));
  EXPECT_TRUE(std::isnan(meanInterval(std::vector{1.0})));
  EXPECT_EQ(meanInterval(std::vector{1.0, 4.0}), 3);
  EXPECT_EQ(meanInterval(std::vector{1.0, 2.0, 5.0}), 2);
}

TEST(AsymptoticFlipInterval, IsTheFormulaOfItsDescription) {
  const double i1 = kMoments[1], i2 = kMoments[0], i3 = kMoments[2];
  ASSERT_TRUE(i1 < i2 && i2 < i3);
  const double eps = 1e-4;
  const double lambda = kSpinRate * std::sqrt((i2 - i1) * (i3 - i2) / (i1 * i3));
  const double kappa3 = i3 * (i3 - i1) / (i2 * (i2 - i1));
  const double kappa1 = i1 * (i3 - i1) / (i2 * (i3 - i2));
  EXPECT_NEAR(lawOf(tilted(eps, 2)), 2 / lambda * std::log(4 / (std::sqrt(kappa3) * eps)), 1e-8);
  EXPECT_NEAR(lawOf(tilted(eps, 1)), 2 / lambda * std::log(4 / (std::sqrt(kappa1) * eps)), 1e-8);
}

TEST(AsymptoticFlipInterval, IsTheLimitOfTheExactIntervalWhicheverWayItTilts) {
  for (const int axis : {1, 2}) {
    EXPECT_LT(std::fabs(deviation(1e-4, axis)), kTinyTiltBound) << axis;
    // Quadratic: a tenth of the tilt makes about a hundredth of the deviation.
    const double ratio = deviation(0.01, axis) / deviation(0.001, axis);
    EXPECT_GT(ratio, 60) << axis;  // measured 94.7 and 70.3
    EXPECT_LT(ratio, 120) << axis;
  }
}

// The formula takes the angle, not its sine, which at 0.1 is ten times farther from the truth.
TEST(AsymptoticFlipInterval, IsCloseAtATenthOfARadian) {
  EXPECT_LT(std::fabs(deviation(0.1, 2)), kLargeTiltBound);
}

TEST(AsymptoticFlipInterval, IsInfiniteWhereNothingEverFlips) {
  EXPECT_EQ(lawOf(spinning(Model::Exact, {kSpinRate, 0, 0}, 1)),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(asymptoticFlipInterval({{1, 1, 1.5}}, {5, 0.1, 0.2}),
            std::numeric_limits<double>::infinity());
}

TEST(MiddleAxis, IsThatOfTheMiddleMoment) {
  EXPECT_EQ(middleAxis({{2, 1, 3}}), Vector3d(1, 0, 0));
  EXPECT_EQ(middleAxis({{1.5, 3, 2}}), Vector3d(0, 0, 1));
}

}  // namespace
}  // namespace rotatebook::physics
