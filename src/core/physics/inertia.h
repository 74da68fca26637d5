// Inertia tensors and their principal axes.
#pragma once

#include <Eigen/Core>

#include "base/double_double.h"

namespace rotatebook::physics {

/// An inertia tensor taken apart: P diag(moments) P^T.
struct PrincipalAxes {
  Eigen::Vector3d moments{1, 1, 1};  ///< [kg m^2]
  /// P, a rotation: its columns are the principal axes in the body's own.
  Eigen::Matrix3d bodyFromPrincipal = Eigen::Matrix3d::Identity();

  /// What both lack of twice a double's precision, in which they were computed. [kg m^2]
  Eigen::Vector3d momentsLow{0, 0, 0};
  Eigen::Matrix3d bodyFromPrincipalLow = Eigen::Matrix3d::Zero();

  /// The moments to twice a double's precision. [kg m^2]
  DoubleDouble3 preciseMoments() const;
  /// P^T v, to 1e-29 of |v|, and less where moments are close; components under that are 0, unless
  /// P is the identity, which takes v as it is. So a spin about an axis of a turned tensor stays
  /// about it.
  DoubleDouble3 alongPrincipal(const Eigen::Vector3d& v) const;

  /// The angular velocity that belongs to an angular momentum, both along the body's axes.
  Eigen::Vector3d angularVelocity(const Eigen::Vector3d& momentum) const;
  /// The other way round.
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& velocity) const;
};

/// Throws InputError with the reason if no body can have this inertia tensor [kg m^2]: not
/// symmetric, not positive definite, or one principal moment larger than the sum of the others.
/// Rounding in the last digits (1e-12 of the largest entry) is forgiven, and a moment that is no
/// more than that is refused as 0; so is a body whose moments are all under 1e-30.
void checkInertia(const Eigen::Matrix3d& tensor);

/// The principal axes of a symmetric tensor. One that is diagonal keeps the order of its axes, with
/// P exactly the identity; else the moments come smallest first, with moments that agree to 1e-29
/// of the largest made equal. By Jacobi's rotations in pairs of doubles, which take the tensor's
/// numbers as exact.
PrincipalAxes principalAxes(const Eigen::Matrix3d& tensor);

}  // namespace rotatebook::physics
