#include "physics/cage_fit.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFitBound = 1e-14;  // measured 7.7e-16

// A rotation and three stretches.
Matrix3d someMap() {
  const Matrix3d turn = Eigen::AngleAxisd(0.8, Vector3d(1, -2, 2) / 3).toRotationMatrix();
  return turn * Vector3d(1, 0.25, 1.5).asDiagonal();
}

double distance(const body::Cage& cage, const Matrix3d& expected) {
  return (CageFit(body::Cuboid()).worldFromBody(cage) - expected).norm();
}

TEST(CageFit, FindsTheMapWhereverTheBodyIs) {
  const body::Cage cage = someMap() * body::Cuboid().corners();
  EXPECT_LT(distance(cage, someMap()), kFitBound);
  EXPECT_LT(distance(cage.colwise() + Vector3d(0.1, -0.2, 0.3), someMap()), kFitBound);
}

TEST(CageFit, FitsCornersThatNoLinearMapReaches) {
  body::Cage cage = someMap() * body::Cuboid().corners();
  for (int i = 0; i < 8; ++i)
    cage.col(i) += 0.02 * Vector3d(std::sin(i), std::cos(3 * i), std::sin(5 * i));
  // Solve the least squares by another road: QR of the eight equations of each row of the map.
  const Eigen::Matrix<double, 8, 3> equations = body::Cuboid().corners().transpose();
  const Matrix3d expected = equations.householderQr().solve(cage.transpose()).transpose();
  EXPECT_LT(distance(cage, expected), kFitBound);
  EXPECT_GT((expected - someMap()).norm(), 0.01);
}

}  // namespace
}  // namespace rotatebook::physics
