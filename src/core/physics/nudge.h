// A knock on the way: an impulse that changes a spin in a moment.
#pragma once

#include <Eigen/Core>

namespace rotatebook::physics {

/// The quantity by which a spin is given.
enum class SpinKind { AngularVelocity, AngularMomentum };

/// A change of a body's angular velocity or momentum at one moment, in which it doesn't turn.
struct Nudge {
  enum class Axes { Body, World };

  double at = 0;  ///< Time of the nudge, > 0. [s]
  SpinKind kind = SpinKind::AngularVelocity;
  Eigen::Vector3d value{0, 0, 0};  ///< Added to the spin. [rad/s] or [kg m^2/s]
  Axes axes = Axes::Body;          ///< The axes that `value` is along, at that moment.

  friend bool operator==(const Nudge&, const Nudge&) = default;
};

}  // namespace rotatebook::physics
