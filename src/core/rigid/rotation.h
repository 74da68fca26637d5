// Rotations, and linear maps that should be rotations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/layout.h"

namespace rotatebook::rigid {

/// Returns the matrix [w]x, for which [w]x v = w x v.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d result;
  result << 0, -w.z(), w.y(),  //
      w.z(), 0, -w.x(),        //
      -w.y(), w.x(), 0;
  return result;
}

/// Returns A(q), the textbook matrix of a unit quaternion, without dividing by |q|^2: for a
/// quaternion that isn't of unit norm, this map isn't a rotation. A(conj q) is its transpose.
inline Eigen::Matrix3d unnormalisedMatrix(const Eigen::Quaterniond& q) {
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  Eigen::Matrix3d result;
  result << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),        //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return result;
}

/// Returns the orthogonal matrix closest to `map`: U V^T where `map` = U S V^T, to 1e-14. Its
/// determinant has the sign of that of `map`. Not finite if `map` isn't.
Eigen::Matrix3d polarFactor(const Eigen::Matrix3d& map);

/// A polar decomposition: a linear map as a rotation and stretches.
struct Polar {
  Eigen::Matrix3d rotation;  ///< The proper rotation closest to the map, even if the map mirrors.
  Eigen::Vector3d singularValues;  ///< >= 0, largest first.
};

/// Decomposes `map`, which must be finite. A map that is a rotation, to rounding, is returned as it
/// is, with singular values of 1. If its determinant is negative, the direction of the smallest
/// singular value is taken as mirrored (Kabsch 1976).
Polar polarDecomposition(const Eigen::Matrix3d& map);

}  // namespace rotatebook::rigid
