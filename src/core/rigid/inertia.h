// Inertia tensors and their principal axes.
#pragma once

#include <Eigen/Core>

#include "base/double_double.h"
#include "base/layout.h"

namespace rotatebook::rigid {

/// The eigendecomposition of an inertia tensor, P diag(moments) P^T.
struct PrincipalAxes {
  Eigen::Vector3d moments{1, 1, 1};  ///< [kg m^2]
  /// P, a rotation: its columns are the principal axes in body axes.
  Eigen::Matrix3d bodyFromPrincipal = Eigen::Matrix3d::Identity();

  /// The low parts of both, which are double-double numbers. [kg m^2]
  Eigen::Vector3d momentsLow{0, 0, 0};
  Eigen::Matrix3d bodyFromPrincipalLow = Eigen::Matrix3d::Zero();

  /// Returns the moments as double-double numbers. [kg m^2]
  DoubleDouble3 preciseMoments() const;
  /// Returns P^T v, to 1e-29 of |v|, less precisely where moments are close. Components below that
  /// error are set to 0, so that a spin about a principal axis of a rotated tensor stays about it;
  /// where P is the identity, v is returned as it is.
  DoubleDouble3 alongPrincipal(const Eigen::Vector3d& v) const;

  /// Returns the angular velocity that belongs to an angular momentum, both in body axes.
  Eigen::Vector3d angularVelocity(const Eigen::Vector3d& momentum) const;
  /// Returns the angular momentum that belongs to an angular velocity, both in body axes.
  Eigen::Vector3d angularMomentum(const Eigen::Vector3d& velocity) const;
};

/// Returns the axes with moments that agree to 1e-12 made equal: turning a body rounds its moments,
/// by 3e-16, and equal ones come apart. For what is said of a body; its motion has its own moments.
PrincipalAxes withEqualMoments(PrincipalAxes axes);

/// Sets products of inertia that rounding alone makes to 0, so that a spin about an axis of a
/// symmetric body is exactly about it.
void clearRounding(Eigen::Matrix3d& tensor);

/// Returns the principal axes of a symmetric tensor. A diagonal tensor keeps the order of its axes,
/// with P exactly the identity; otherwise the moments are sorted, smallest first, and moments that
/// agree to 1e-29 of the largest are made equal. Uses Jacobi rotations in double-double arithmetic,
/// which take the tensor's entries as exact.
PrincipalAxes principalAxes(const Eigen::Matrix3d& tensor);

/// An inertia tensor in body axes with its principal axes, which are found once. [kg m^2]
class Inertia {
 public:
  /// Takes a symmetric tensor.
  template <typename Derived>
  Inertia(const Eigen::EigenBase<Derived>& tensor)
      : tensor_(tensor), axes_(principalAxes(tensor_)) {}

  const Eigen::Matrix3d& tensor() const { return tensor_; }
  const PrincipalAxes& axes() const { return axes_; }
  friend bool operator==(const Inertia& a, const Inertia& b) { return a.tensor_ == b.tensor_; }

 private:
  Eigen::Matrix3d tensor_;
  PrincipalAxes axes_;
};

/// Returns the inertia of a body with this tensor [kg m^2]. Throws InputError with the reason if no
/// body can have it: it is not finite, not symmetric, not positive definite, or has a principal
/// moment larger than the sum of the other two. Rounding in the last digits (1e-12 of the largest
/// entry) is allowed, so a moment no larger than that is rejected as 0; so is a body whose moments
/// are all under 1e-30.
Inertia checkedInertia(const Eigen::Matrix3d& tensor);

}  // namespace rotatebook::rigid
