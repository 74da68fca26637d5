#include "rigid/inertia.h"

#include <string>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::rigid {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double kInertiaBound = 1e-14;  // relative; measured 1.4e-15

Matrix3d diagonal(double x, double y, double z) {
  return Vector3d(x, y, z).asDiagonal();
}

Matrix3d someRotation() {
  return AngleAxisd(0.7, Vector3d(2, -1, 2) / 3).toRotationMatrix();
}

std::string refusalOf(const Matrix3d& tensor) {
  try {
    checkedInertia(tensor);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PrincipalAxes, AreTheBodysOwnIfTheTensorIsDiagonal) {
  const PrincipalAxes axes = principalAxes(diagonal(5, 3, 4));
  EXPECT_EQ(axes.moments, Vector3d(5, 3, 4));
  EXPECT_EQ(axes.bodyFromPrincipal, Matrix3d::Identity());
}

TEST(PrincipalAxes, TakeATensorApart) {
  const Matrix3d rotation = someRotation();
  const Matrix3d tensor = rotation * diagonal(3, 4, 5) * rotation.transpose();
  const auto [moments, axes, momentsLow, axesLow] = principalAxes(tensor);
  EXPECT_LT((moments - Vector3d(3, 4, 5)).norm(), 5 * kInertiaBound);
  EXPECT_LT((axes * moments.asDiagonal() * axes.transpose() - tensor).norm(), 5 * kInertiaBound);
  EXPECT_NEAR(axes.determinant(), 1, kInertiaBound);
}

TEST(PrincipalAxes, TurnMomentumIntoVelocityAndBack) {
  const Matrix3d rotation = someRotation();
  const Matrix3d tensor = rotation * diagonal(3, 4, 5) * rotation.transpose();
  const PrincipalAxes axes = principalAxes(tensor);
  const Vector3d velocity(1, -2, 3);
  EXPECT_LT((axes.angularMomentum(velocity) - tensor * velocity).norm(), 20 * kInertiaBound);
  EXPECT_LT((axes.angularVelocity(tensor * velocity) - velocity).norm(), 20 * kInertiaBound);
}

TEST(CheckInertia, TakesWhatABodyCanHave) {
  EXPECT_EQ(refusalOf(diagonal(3, 4, 5)), "");
  EXPECT_EQ(refusalOf(diagonal(1, 1, 2)), "");        // flat
  EXPECT_EQ(refusalOf(diagonal(0.1, 0.2, 0.3)), "");  // flat, but for rounding
  EXPECT_EQ(refusalOf(diagonal(1e-9, 1, 1)), "");
  EXPECT_EQ(refusalOf(1e-30 * diagonal(1e-9, 1, 1)), "");
  EXPECT_EQ(refusalOf(1e21 * diagonal(1e-9, 1, 1)), "");
}

TEST(CheckInertia, RefusesWhatNoBodyHas) {
  EXPECT_THAT(refusalOf(diagonal(1, 1, 2.001)),
              HasSubstr("a principal moment can't exceed the sum of the other two, but its "
                        "principal moments are 1, 1 and 2.001"));
  EXPECT_THAT(refusalOf(diagonal(1, 1, 2 + 1e-10)), HasSubstr("no body has this inertia"));
  EXPECT_THAT(refusalOf(diagonal(0, 1, 1)), HasSubstr("must be positive definite"));
  EXPECT_THAT(refusalOf(diagonal(-1, 1, 1)), HasSubstr("must be positive definite"));
  Matrix3d indefinite;
  indefinite << 1, 2, 0, 2, 1, 0, 0, 0, 1;
  EXPECT_THAT(refusalOf(indefinite), HasSubstr("principal moments are -1, 1 and 3"));
}

TEST(CheckInertia, RefusesWhatIsTooSmallToComputeWith) {
  EXPECT_THAT(
      refusalOf(diagonal(1e-13, 1, 1)),
      HasSubstr("smallest principal moment must be more than 1e-12 of the largest, but its"));
  EXPECT_THAT(refusalOf(1e-31 * diagonal(1, 1, 1)),
              HasSubstr("principal moments of 1e-30 kg m^2 or more, but its principal moments are "
                        "1e-31, 1e-31 and 1e-31"));
}

TEST(CheckInertia, ForgivesRoundingAlone) {
  Matrix3d tensor = diagonal(3, 4, 5);
  tensor(0, 1) = 1e-14;
  EXPECT_EQ(refusalOf(tensor), "");
  tensor(0, 1) = 1e-10;
  EXPECT_THAT(refusalOf(tensor), HasSubstr("must be symmetric"));
}

TEST(CheckInertia, RefusesAsymmetryAndNamesTheEntries) {
  Matrix3d tensor = diagonal(3, 4, 5);
  tensor(0, 2) = 0.1;
  EXPECT_THAT(refusalOf(tensor), HasSubstr("must be symmetric, but its xz entries are 0.1 and 0"));
}

}  // namespace
}  // namespace rotatebook::rigid
