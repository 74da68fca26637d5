// The exact motion along the body's axes.
#pragma once

#include <Eigen/Core>

#include "physics/exact/exact_motion.h"
#include "physics/inertia.h"
#include "physics/measure/regime.h"

namespace rotatebook::physics {

/// The exact free rotation of a body with any inertia tensor; body and world axes agree at t = 0.
class ExactRotation {
 public:
  /// `angularVelocity` at t = 0. [rad/s]
  ExactRotation(const PrincipalAxes& inertia, const Eigen::Vector3d& angularVelocity);
  /// `alongPrincipal` is the same along the principal axes.
  ExactRotation(const PrincipalAxes& inertia, const DoubleDouble3& alongPrincipal);

  struct Moment {
    Eigen::Matrix3d worldFromBody;
    Eigen::Vector3d angularVelocity;  ///< In the world's axes. [rad/s]
  };
  /// At any time. [s]
  Moment at(double time) const;

  Regime regime() const { return motion_.regime(); }

 private:
  Eigen::Matrix3d bodyFromPrincipal_;
  ExactMotion motion_;
};

}  // namespace rotatebook::physics
