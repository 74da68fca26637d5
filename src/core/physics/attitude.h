// Operations of all integrators on an attitude, be it a quaternion or a matrix; an attitude maps
// principal axes to the world. Inside the room only.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "rigid/rotation.h"

namespace rotatebook::physics {

/// Returns the linear map that the attitude represents: a rotation, or what drift has made of one.
inline Eigen::Matrix3d mapOf(const Eigen::Quaterniond& attitude) {
  return rigid::unnormalisedMatrix(attitude);
}
inline const Eigen::Matrix3d& mapOf(const Eigen::Matrix3d& attitude) {
  return attitude;
}

/// Rotates by the unit quaternion `turn`, given in world axes.
inline void turnInWorld(Eigen::Quaterniond& attitude, const Eigen::Quaterniond& turn) {
  attitude = turn * attitude;
}
inline void turnInWorld(Eigen::Matrix3d& attitude, const Eigen::Quaterniond& turn) {
  attitude = rigid::unnormalisedMatrix(turn) * attitude;
}

/// Rotates by the unit quaternion `turn`, given in body axes.
inline void turnInBody(Eigen::Quaterniond& attitude, const Eigen::Quaterniond& turn) {
  attitude = attitude * turn;
}
inline void turnInBody(Eigen::Matrix3d& attitude, const Eigen::Quaterniond& turn) {
  attitude = attitude * rigid::unnormalisedMatrix(turn);
}

/// Returns the derivative at the angular velocity `w` in body axes: q (0, w) / 2 or R [w]x. [1/s]
inline Eigen::Quaterniond rateInBody(const Eigen::Quaterniond& attitude, const Eigen::Vector3d& w) {
  const Eigen::Vector3d half = w / 2;
  return attitude * Eigen::Quaterniond(0, half.x(), half.y(), half.z());
}
inline Eigen::Matrix3d rateInBody(const Eigen::Matrix3d& attitude, const Eigen::Vector3d& w) {
  return attitude * rigid::crossMatrix(w);
}

/// Returns attitude + factor * rate, component by component.
inline Eigen::Quaterniond addScaled(const Eigen::Quaterniond& attitude, double factor,
                                    const Eigen::Quaterniond& rate) {
  return Eigen::Quaterniond(attitude.coeffs() + factor * rate.coeffs());
}
inline Eigen::Matrix3d addScaled(const Eigen::Matrix3d& attitude, double factor,
                                 const Eigen::Matrix3d& rate) {
  return attitude + factor * rate;
}

/// Returns 1/sqrt(x), to rounding. Near 1, where the squared norm of an attitude is after a short
/// step, a series is faster than a root and a division.
inline double inverseRoot(double x) {
  constexpr double kNearOne = 1e-4;  // The next term of the series is below 3e-17 here.
  const double e = x - 1;
  if (std::abs(e) > kNearOne) return 1 / std::sqrt(x);
  return (1 - e / 2) + e * e * (0.375 - 0.3125 * e);
}

/// Undoes drift: takes the nearest quaternion of unit norm, or the nearest orthogonal matrix.
inline void normalize(Eigen::Quaterniond& attitude) {
  attitude.coeffs() *= inverseRoot(attitude.squaredNorm());
}
inline void normalize(Eigen::Matrix3d& attitude) {
  attitude = rigid::polarFactor(attitude);
}

}  // namespace rotatebook::physics
