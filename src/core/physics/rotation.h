// Rotations, and the maps that ought to be rotations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rotatebook::physics {

/// The matrix [w]x with [w]x v = w x v.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d result;
  result << 0, -w.z(), w.y(),  //
      w.z(), 0, -w.x(),        //
      -w.y(), w.x(), 0;
  return result;
}

/// A(q), the textbook conversion of a unit quaternion to a rotation matrix, applied as it stands:
/// of a quaternion that is not of unit norm it makes a map that isn't a rotation. A(conj q) is its
/// transpose.
inline Eigen::Matrix3d unnormalisedMatrix(const Eigen::Quaterniond& q) {
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  Eigen::Matrix3d result;
  result << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),        //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return result;
}

/// The orthogonal matrix nearest to `map`: U V^T where `map` = U S V^T, to 1e-14. Its determinant
/// has the sign of that of `map`. Not finite if `map` isn't.
Eigen::Matrix3d polarFactor(const Eigen::Matrix3d& map);

/// A linear map taken apart into a rotation and stretches.
struct Polar {
  Eigen::Matrix3d rotation;  ///< The proper rotation nearest to the map, even where the map turns
                             ///< it inside out.
  Eigen::Vector3d singularValues;  ///< >= 0, largest first.
};

/// Takes `map`, which is finite, apart; a rotation, to rounding, is returned as it is, with
/// singular values of 1. Where its determinant is negative the direction of the smallest singular
/// value is taken as turned inside out (Kabsch 1976).
Polar polarDecomposition(const Eigen::Matrix3d& map);

}  // namespace rotatebook::physics
