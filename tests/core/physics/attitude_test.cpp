#include "physics/attitude.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace rotatebook::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kRootBound = 5e-16;      // measured 3.4e-16
constexpr double kAttitudeBound = 2e-15;  // measured 5e-16

const Quaterniond kAttitude(AngleAxisd(0.8, Vector3d(1, -2, 2) / 3));
const Quaterniond kTurn(AngleAxisd(-0.5, Vector3d(2, 2, 1) / 3));

// By the series, at its ends, and beyond.
TEST(InverseRoot, IsTheReciprocalRootToRounding) {
  double worst = 0;
  for (int i = -2000; i <= 2000; ++i) {
    const double x = 1 + i * 1e-7;
    worst = std::max(worst, std::abs(inverseRoot(x) * std::sqrt(x) - 1));
  }
  EXPECT_LT(worst, kRootBound);
  EXPECT_EQ(inverseRoot(0.25), 2);
  EXPECT_EQ(inverseRoot(4.0), 0.5);
}

// A matrix and a quaternion are two names of one attitude: whatever is done to both, they agree.
TEST(Attitude, IsTheSameAsQuaternionAndAsMatrix) {
  const auto distance = [](const Quaterniond& quaternion, const Matrix3d& matrix) {
    return (mapOf(quaternion) - mapOf(matrix)).norm();
  };
  Quaterniond quaternion = kAttitude;
  Matrix3d matrix = kAttitude.toRotationMatrix();
  turnInWorld(quaternion, kTurn);
  turnInWorld(matrix, kTurn);
  EXPECT_LT(distance(quaternion, matrix), kAttitudeBound);
  EXPECT_LT((matrix - (kTurn * kAttitude).toRotationMatrix()).norm(), kAttitudeBound);
  turnInBody(quaternion, kTurn);
  turnInBody(matrix, kTurn);
  EXPECT_LT(distance(quaternion, matrix), kAttitudeBound);
  EXPECT_LT((matrix - (kTurn * kAttitude * kTurn).toRotationMatrix()).norm(), kAttitudeBound);
}

TEST(Attitude, ComesBackToARotation) {
  Quaterniond quaternion(3 * kAttitude.coeffs());
  Matrix3d matrix = 3 * kAttitude.toRotationMatrix();
  normalize(quaternion);
  normalize(matrix);
  EXPECT_LT((quaternion.coeffs() - kAttitude.coeffs()).norm(), kAttitudeBound);
  EXPECT_LT((matrix - kAttitude.toRotationMatrix()).norm(), kAttitudeBound);
}

}  // namespace
}  // namespace rotatebook::physics
