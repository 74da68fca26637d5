#include "physics/motion_settings.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr double kSettingsBound = 5e-15;   // measured 9e-16
constexpr double kTinyAngleBound = 1e-15;  // relative; measured 0

Vector3d tilted(const Vector3d& value, double angle, int axis) {
  return InitialSpin{.value = value, .tilt = Tilt{angle, axis}}.tilted();
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(InitialSpin, TurnsFromOneAxisTowardAnother) {
  const double root3 = std::sqrt(3.0);
  EXPECT_LT((tilted({2, 0, 0}, kPi / 6, 1) - Vector3d(root3, 1, 0)).norm(), kSettingsBound);
  EXPECT_LT((tilted({-2, 0, 0}, kPi / 6, 2) - Vector3d(-root3, 0, 1)).norm(), kSettingsBound);
  EXPECT_LT((tilted({0, 0, 2}, -kPi / 6, 0) - Vector3d(-1, 0, root3)).norm(), kSettingsBound);
}

TEST(InitialSpin, TurnsByTheAngleInThePlaneOfItselfAndTheAxis) {
  const Vector3d value(3, -4, 5);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d result = tilted(value, 0.3, axis);
    const Vector3d toward = Vector3d::Unit(axis);
    EXPECT_NEAR(result.norm(), value.norm(), kSettingsBound);
    EXPECT_NEAR(angleBetween(result, value), 0.3, kSettingsBound);
    EXPECT_NEAR(angleBetween(result, toward), angleBetween(value, toward) - 0.3, kSettingsBound);
    EXPECT_NEAR(result.cross(value).dot(toward), 0, kSettingsBound * value.norm());
  }
}

TEST(InitialSpin, KeepsTheDigitsOfATinyAngle) {
  EXPECT_NEAR(tilted({1, 0, 0}, 1e-9, 1).y() / 1e-9, 1, kTinyAngleBound);
}

TEST(InitialSpin, RefusesToTiltTowardItsOwnDirection) {
  EXPECT_THROW(tilted({0, 0, 0.7}, 0.1, 2), InputError);
  EXPECT_THROW(tilted({0, 0, 0}, 0.1, 2), InputError);
  try {
    tilted({0, -6.5, 0}, 0.1, 1);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("(0, -6.5, 0) toward y"));
  }
}

TEST(InitialSpin, IsItselfWithoutTilt) {
  EXPECT_EQ((InitialSpin{.value = {0.1, 0.2, 0.3}}.tilted()), Vector3d(0.1, 0.2, 0.3));
}

TEST(InitialSpin, GivesTheSameAngularVelocityToEveryInertia) {
  const InitialSpin spin{.value = {1, 2, 3}};
  EXPECT_EQ(spin.angularVelocity(rigid::PrincipalAxes{{7, 8, 9}}), Vector3d(1, 2, 3));
}

TEST(InitialSpin, DividesAnAngularMomentumByTheInertiaAfterTilting) {
  const InitialSpin spin{
      .kind = InitialSpin::Kind::AngularMomentum, .value = {8, 0, 0}, .tilt = Tilt{kPi / 2, 1}};
  EXPECT_LT((spin.angularVelocity(rigid::PrincipalAxes{{2, 4, 8}}) - Vector3d(0, 2, 0)).norm(),
            kSettingsBound);
}

}  // namespace
}  // namespace rotatebook::physics
