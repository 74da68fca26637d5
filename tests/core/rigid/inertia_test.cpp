#include "rigid/inertia.h"

#include <string>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"

namespace rotatebook::rigid {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

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
  EXPECT_MESSAGE(refusalOf(diagonal(1, 1, 2.001)));
  EXPECT_MESSAGE(refusalOf(diagonal(1, 1, 2 + 1e-10)));
  EXPECT_MESSAGE(refusalOf(diagonal(0, 1, 1)));
  EXPECT_MESSAGE(refusalOf(diagonal(-1, 1, 1)));
  Matrix3d indefinite;
  indefinite << 1, 2, 0, 2, 1, 0, 0, 0, 1;
  EXPECT_MESSAGE(refusalOf(indefinite));
}

TEST(CheckInertia, RefusesWhatIsTooSmallToComputeWith) {
  EXPECT_MESSAGE(refusalOf(diagonal(1e-13, 1, 1)));
  EXPECT_MESSAGE(refusalOf(1e-31 * diagonal(1, 1, 1)));
}

TEST(CheckInertia, ForgivesRoundingAlone) {
  Matrix3d tensor = diagonal(3, 4, 5);
  tensor(0, 1) = 1e-14;
  EXPECT_EQ(refusalOf(tensor), "");
  tensor(0, 1) = 1e-10;
  EXPECT_MESSAGE(refusalOf(tensor));
}

TEST(CheckInertia, RefusesAsymmetryAndNamesTheEntries) {
  Matrix3d tensor = diagonal(3, 4, 5);
  tensor(0, 2) = 0.1;
  EXPECT_MESSAGE(refusalOf(tensor));
}

}  // namespace
}  // namespace rotatebook::rigid
