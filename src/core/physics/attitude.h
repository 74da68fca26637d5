// Operations of all integrators on an attitude, be it a quaternion or a matrix; an attitude maps
// principal axes to the world. Inside the room only.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/steps/number.h"
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

/// Undoes drift: takes the nearest quaternion of unit norm, or the nearest orthogonal matrix.
inline void normalize(Eigen::Quaterniond& attitude) {
  attitude.coeffs() *= inverseRoot(attitude.squaredNorm());
}
inline void normalize(Eigen::Matrix3d& attitude) {
  attitude = rigid::polarFactor(attitude);
}

}  // namespace rotatebook::physics
