#include "rigid/rotation.h"

#include <cmath>
#include <random>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

namespace rotatebook::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int kTries = 2000;
constexpr double kRotationBound = 5e-14;      // measured 8e-15
constexpr double kNearRotationBound = 1e-14;  // measured 2.5e-15
constexpr double kPerConditionBound = 1e-14;  // error / condition number; measured 1e-15

class Random {
 public:
  double number() { return distribution_(generator_); }
  Vector3d vector() { return {number(), number(), number()}; }
  Matrix3d matrix() {
    Matrix3d result;
    result << vector(), vector(), vector();
    return result;
  }
  Matrix3d rotation() {
    return Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix();
  }

 private:
  std::mt19937 generator_{20240229};
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

double condition(const Matrix3d& map) {
  const Vector3d values = map.jacobiSvd().singularValues();
  return values[0] / values[2];
}

Matrix3d polarFactorBySvd(const Matrix3d& map) {
  const Eigen::JacobiSVD<Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

double distanceFromOrthogonal(const Matrix3d& map) {
  return (map.transpose() * map - Matrix3d::Identity()).norm();
}

TEST(CrossMatrix, MultipliesAsTheCrossProduct) {
  const Vector3d a(1, 2, 3), b(-4, 5, 7);
  EXPECT_EQ(crossMatrix(a) * b, a.cross(b));
}

TEST(UnnormalisedMatrix, IsTheRotationOfAUnitQuaternion) {
  const Quaterniond q(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3));
  const Vector3d v(0.3, -0.4, 0.5);
  EXPECT_LT(
      (unnormalisedMatrix(q) * v - (q * Quaterniond(0, v.x(), v.y(), v.z()) * q.conjugate()).vec())
          .norm(),
      kRotationBound);
}

TEST(UnnormalisedMatrix, IsNotDividedByTheNorm) {
  Matrix3d expected;
  expected << -25, -20, 22,  //
      28, -19, 4,            //
      -10, 20, -9;
  EXPECT_EQ(unnormalisedMatrix(Quaterniond(4, 1, 2, 3)), expected);
}

TEST(PolarFactor, IsThatOfTheSvdOnRandomMaps) {
  Random random;
  double worst = 0;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d map = random.matrix();
    const double difference = (polarFactor(map) - polarFactorBySvd(map)).norm();
    worst = std::max(worst, difference / condition(map));
  }
  EXPECT_LT(worst, kPerConditionBound);
}

TEST(PolarFactor, IsThatOfTheSvdNearARotation) {
  Random random;
  double worst = 0;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d map = random.rotation() + 0.1 * random.matrix();
    worst = std::max(worst, (polarFactor(map) - polarFactorBySvd(map)).norm());
  }
  EXPECT_LT(worst, kNearRotationBound);
}

TEST(PolarFactor, KeepsTheSignOfTheDeterminant) {
  Random random;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d map = random.matrix();
    EXPECT_NEAR(polarFactor(map).determinant(), std::copysign(1, map.determinant()),
                kRotationBound);
  }
}

TEST(PolarFactor, IsOrthogonalEvenOfAFlatMap) {
  const Matrix3d plane = Vector3d(2, 3, 0).asDiagonal();
  const Matrix3d line = Vector3d(1, 2, 3) * Vector3d(4, 5, 6).transpose();
  for (const Matrix3d& map : {plane, line, Matrix3d(Matrix3d::Zero())}) {
    EXPECT_LT(distanceFromOrthogonal(polarFactor(map)), kRotationBound) << map;
  }
}

TEST(PolarFactor, IsThatOfAMapOfAnySize) {
  Random random;
  const Matrix3d map = random.matrix();
  for (const double size : {1e-200, 1e-3, 1e3, 1e200}) {
    EXPECT_LT((polarFactor(size * map) - polarFactor(map)).norm(), kRotationBound);
  }
}

TEST(PolarFactor, IsNotFiniteOfWhatIsNotFinite) {
  const Matrix3d flat = Vector3d(2, 3, 0).asDiagonal();
  for (const double number : {std::nan(""), HUGE_VAL}) {
    Matrix3d one = Matrix3d::Identity();
    one(1, 2) = number;
    for (const Matrix3d& map : {one, Matrix3d(Matrix3d::Constant(number))}) {
      // A finite factor just before, by the same road, is what a factor never set would show.
      EXPECT_TRUE(polarFactor(flat).allFinite());
      EXPECT_FALSE(polarFactor(map).allFinite()) << map;
    }
  }
}

TEST(PolarDecomposition, FindsTheRotationAndTheStretches) {
  Random random;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d rotation = random.rotation(), axes = random.rotation();
    const Matrix3d stretch = axes * Vector3d(0.5, 3, 2).asDiagonal() * axes.transpose();
    const Polar polar = polarDecomposition(rotation * stretch);
    EXPECT_LT((polar.rotation - rotation).norm(), kRotationBound);
    EXPECT_LT((polar.singularValues - Vector3d(3, 2, 0.5)).norm(), kRotationBound);
  }
}

TEST(PolarDecomposition, LeavesARotationAsItIs) {
  Random random;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d rotation = random.rotation();
    const Polar polar = polarDecomposition(rotation);
    EXPECT_EQ(polar.rotation, rotation);
    EXPECT_EQ(polar.singularValues, Vector3d::Ones());
    EXPECT_NEAR(polarDecomposition(-rotation).rotation.determinant(), 1, kRotationBound);
    EXPECT_GT(polarDecomposition(1.0001 * rotation).singularValues[2], 1.00009);
  }
}

TEST(PolarDecomposition, FindsTheRotationOfAMapTurnedInsideOut) {
  Random random;
  for (int i = 0; i < kTries; ++i) {
    const Matrix3d rotation = random.rotation(), axes = random.rotation();
    const Matrix3d insideOut = axes * Vector3d(-0.5, 3, 2).asDiagonal() * axes.transpose();
    const Polar polar = polarDecomposition(rotation * insideOut);
    EXPECT_LT((polar.rotation - rotation).norm(), kRotationBound);
    EXPECT_LT((polar.singularValues - Vector3d(3, 2, 0.5)).norm(), kRotationBound);
  }
}

TEST(PolarDecomposition, FindsAProperRotationOfAFlatMap) {
  const Matrix3d line = Vector3d(1, 2, 3) * Vector3d(4, 5, -6).transpose();
  for (const Matrix3d& map : {line, Matrix3d(-line), Matrix3d(Matrix3d::Zero())}) {
    const Matrix3d rotation = polarDecomposition(map).rotation;
    EXPECT_LT(distanceFromOrthogonal(rotation), kRotationBound);
    EXPECT_NEAR(rotation.determinant(), 1, kRotationBound);
  }
}

}  // namespace
}  // namespace rotatebook::rigid
