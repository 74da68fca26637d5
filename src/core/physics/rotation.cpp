#include "physics/rotation.h"

#include <limits>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace rotatebook::physics {
namespace {

// The Newton iteration converges quadratically: after a step of size s the error is about s^2 / 2.
constexpr double kSmallLastStep = 1e-9;
// Entries of X^T X - 1 up to which X counts as a rotation. Measured 2.5e-15 in 1440 frames of
// normalised Euler steps, and 1.1e-15 in closed form.
constexpr double kRounding = 4e-15;
// From a well-shaped map six steps do; a map that needs more is nearly flat, and the SVD is the
// better tool.
constexpr int kMaxNewtonSteps = 12;

using Svd = Eigen::JacobiSVD<Eigen::Matrix3d>;

Svd fullSvd(const Eigen::Matrix3d& map) {
  return Svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

bool isRotation(const Eigen::Matrix3d& map) {
  const Eigen::Matrix3d strain = map.transpose() * map - Eigen::Matrix3d::Identity();
  return strain.cwiseAbs().maxCoeff() < kRounding && map.determinant() > 0;
}

// Determinant times inverse, transposed.
Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m) {
  Eigen::Matrix3d result;
  result.col(0) = m.col(1).cross(m.col(2));
  result.col(1) = m.col(2).cross(m.col(0));
  result.col(2) = m.col(0).cross(m.col(1));
  return result;
}

}  // namespace

// Newton's iteration X <- (X + X^-T)/2 (Higham 1986), some twenty times faster than the SVD near a
// rotation.
Eigen::Matrix3d polarFactor(const Eigen::Matrix3d& map) {
  Eigen::Matrix3d x = map;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const Eigen::Matrix3d cofactor = cofactors(x);
    const double determinant = x.col(0).dot(cofactor.col(0));
    const Eigen::Matrix3d change = 0.5 * (cofactor / determinant - x);
    x += change;
    if (change.cwiseAbs().maxCoeff() < kSmallLastStep) return x;
  }
  // Of what is not finite the SVD would make the identity, and hide that the motion has blown up.
  if (!map.allFinite()) return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Svd svd = fullSvd(map);
  return svd.matrixU() * svd.matrixV().transpose();
}

Polar polarDecomposition(const Eigen::Matrix3d& map) {
  if (isRotation(map)) return {map, Eigen::Vector3d::Ones()};
  const Svd svd = fullSvd(map);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  return {u * svd.matrixV().transpose(), svd.singularValues()};
}

}  // namespace rotatebook::physics
