// What a motion is looked at from.
#pragma once

#include <Eigen/Core>

#include "physics/sample.h"

namespace rotatebook::scene {

/// Axes that a motion is described in.
enum class ReferenceFrame {
  World,     ///< That of the start, which doesn't turn.
  Body,      ///< Turns with the body's attitude: its axes stand still.
  Momentum,  ///< Turned so that the angular momentum points along +y; at rest if it is conserved.
};

/// The rotation from the world's axes to those of `frame` at this moment. Without angular momentum
/// ReferenceFrame::Momentum is the world's; where it points along -y, the turn is about x.
Eigen::Matrix3d frameFromWorld(ReferenceFrame frame, const physics::Sample& sample);

/// `sample` with cage, attitude, angular velocity and angular momentum along the axes of `frame`
/// at its moment. What has no direction stays as it is.
physics::Sample seenFrom(ReferenceFrame frame, const physics::Sample& sample);

}  // namespace rotatebook::scene
