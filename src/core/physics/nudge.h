// A knock on the way: an impulse that changes a spin in a moment.
#pragma once

#include <Eigen/Core>

namespace rotatebook::physics {

/// A change of a body's angular velocity or momentum at one moment, in which it doesn't turn.
struct Nudge {
  enum class Kind { AngularVelocity, AngularMomentum };
  enum class Axes { Body, World };

  double at = 0;  ///< Time of the nudge, > 0. [s]
  Kind kind = Kind::AngularMomentum;
  Eigen::Vector3d value{0, 0, 0};  ///< What is added. [rad/s] or [kg m^2/s]
  Axes axes = Axes::Body;          ///< The axes that `value` is along, at that moment.

  friend bool operator==(const Nudge&, const Nudge&) = default;
};

}  // namespace rotatebook::physics
