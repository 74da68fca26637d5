// Lengths of the arrows of a motion. Inside the room only.
#pragma once

#include <Eigen/Core>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// Lengths of arrows in the world. They are limited where a motion grows without limit.
class ArrowScale {
 public:
  explicit ArrowScale(const OverlayContext& context);
  /// Returns the tip of the arrow for an angular velocity [rad/s]. [m]
  Eigen::Vector3d omegaTip(const Eigen::Vector3d& angularVelocity) const;
  /// Returns the tip of the arrow for an angular momentum [kg m^2/s]. [m]
  Eigen::Vector3d momentumTip(const Eigen::Vector3d& angularMomentum) const;

 private:
  double reach_;     // of the body from its centre [m]
  double velocity_;  // has the full length [rad/s]
  double momentum_;  // has the full length [kg m^2/s]
};

}  // namespace rotatebook::overlay
