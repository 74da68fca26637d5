// Reference frames in which a motion can be viewed.
#pragma once

#include <Eigen/Core>

#include "physics/sample.h"

namespace rotatebook::scene {

/// A reference frame: the axes that a motion is described in.
enum class ReferenceFrame {
  World,     ///< The body's axes at the start; doesn't turn.
  Body,      ///< Turns with the body's attitude: its axes are at rest.
  Momentum,  ///< Turned so that the angular momentum points along +y; at rest if it is conserved.
};

/// Returns the rotation from world axes to those of `frame` at this moment. Without angular
/// momentum, ReferenceFrame::Momentum is the world's; where it points along -y, the rotation is
/// about x.
Eigen::Matrix3d frameFromWorld(ReferenceFrame frame, const physics::Sample& sample);

/// Returns `sample` with cage, attitude, angular velocity and angular momentum along the axes of
/// `frame` at its moment. Quantities without a direction are unchanged.
physics::Sample inReferenceFrame(ReferenceFrame frame, const physics::Sample& sample);

}  // namespace rotatebook::scene
