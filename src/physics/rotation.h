// Rotations, and the maps that ought to be rotations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rotatebook::physics {

/// The matrix [w]x with [w]x v = w x v.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& w);

/// A(q), the textbook conversion of a unit quaternion to a rotation matrix, applied as it stands:
/// of a quaternion that is not of unit norm it makes a map that isn't a rotation. A(conj q) is its
/// transpose.
Eigen::Matrix3d textbookMatrix(const Eigen::Quaterniond& q);

/// The orthogonal matrix nearest to `map`: U V^T where `map` = U S V^T, to 1e-14. Its determinant
/// has the sign of that of `map`. Not finite if `map` isn't.
Eigen::Matrix3d polarFactor(const Eigen::Matrix3d& map);

/// A linear map taken apart into a rotation and stretches.
struct Polar {
  Eigen::Matrix3d rotation;  ///< The proper rotation nearest to the map, even where the map turns
                             ///< it inside out.
  Eigen::Vector3d singularValues;  ///< >= 0, largest first.
};

/// Takes `map`, which is finite, apart. Where its determinant is negative the direction of the
/// smallest singular value is taken as turned inside out (Kabsch 1976).
Polar polarDecomposition(const Eigen::Matrix3d& map);

}  // namespace rotatebook::physics
