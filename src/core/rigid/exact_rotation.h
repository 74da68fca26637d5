// The exact motion of a body whose axes need not be principal.
#pragma once

#include <Eigen/Core>

#include "rigid/exact_motion.h"
#include "rigid/inertia.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {

/// The exact free rotation of a body with any inertia tensor; body and world axes agree at t = 0.
class ExactRotation {
 public:
  /// Takes the angular velocity at t = 0, in body axes. [rad/s]
  ExactRotation(const PrincipalAxes& inertia, const Eigen::Vector3d& angularVelocity);
  /// Takes the angular velocity at t = 0, along the principal axes. [rad/s]
  ExactRotation(const PrincipalAxes& inertia, const DoubleDouble3& alongPrincipal);

  struct Moment {
    Eigen::Matrix3d worldFromBody;
    Eigen::Vector3d angularVelocity;  ///< In world axes. [rad/s]
  };
  /// Returns the body at any time. [s]
  Moment at(double time) const;
  /// Returns the angular velocity in body axes. [rad/s]
  Eigen::Vector3d angularVelocityBodyAt(double time) const {
    return bodyFromPrincipal_ * motion_.angularVelocityBodyAt(time);
  }

  Regime regime() const { return motion_.regime(); }
  /// Like ExactMotion::flipInterval(). [s]
  double flipInterval() const { return motion_.flipInterval(); }

 private:
  Eigen::Matrix3d bodyFromPrincipal_;
  ExactMotion motion_;
};

}  // namespace rotatebook::rigid
