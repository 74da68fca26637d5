// The exact motion of a body that is nudged on the way.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "physics/nudge.h"
#include "rigid/exact_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// The exact rotation of a body, free from one nudge to the next; body and world axes agree at t =
/// 0, or are turned by a given rotation. Each piece starts anew from the attitude, to 1e-13, that
/// the one before has led to.
class NudgedRotation {
 public:
  /// The body at t = 0.
  struct Start {
    rigid::PrincipalAxes inertia;
    DoubleDouble3 alongPrincipal;  ///< Angular velocity along the principal axes. [rad/s]
    Eigen::Vector3d momentum;      ///< Angular momentum of this spin. [kg m^2/s]
    /// Turns the motion as a whole.
    std::optional<Eigen::Matrix3d> worldFromBody{};
  };
  /// Takes nudges in the order of their times; those along the world's axes are along the axes
  /// that the body has at t = 0.
  NudgedRotation(const Start& start, std::span<const Nudge> nudges);

  struct Moment {
    Eigen::Matrix3d worldFromBody;
    Eigen::Vector3d angularVelocity;  ///< In world axes. [rad/s]
    Eigen::Vector3d angularMomentum;  ///< In world axes. [kg m^2/s]
    rigid::Regime regime;
  };
  /// Returns the body at any time; at that of a nudge, just after it. [s]
  Moment at(double time) const;
  /// Returns the angular velocity in body axes then. [rad/s]
  Eigen::Vector3d angularVelocityBodyAt(double time) const;

 private:
  struct Piece {
    double start;                   // [s]
    Eigen::Matrix3d worldFromBody;  // at the start
    rigid::ExactRotation rotation;  // from there on
    Eigen::Vector3d momentum;       // in world axes [kg m^2/s]
  };

  /// Like at(), as it is where body and world axes agree at t = 0.
  Moment unturned(double time) const;
  void add(const Nudge& nudge);
  /// Returns the index of the last piece that has started; the first one holds before t = 0, too.
  std::size_t pieceAt(double time) const;

  rigid::PrincipalAxes inertia_;
  std::optional<Eigen::Matrix3d> turn_;
  std::vector<Piece> pieces_;  // in the order of their starts; never empty
};

}  // namespace rotatebook::physics
