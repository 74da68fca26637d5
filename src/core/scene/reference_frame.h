// Reference frames in which a motion can be viewed.
#pragma once

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/sample.h"
#include "rigid/inertial_forces.h"

namespace rotatebook::scene {

/// A reference frame: the axes that a motion is described in.
enum class ReferenceFrame {
  World,     ///< The body's axes at the start; doesn't turn.
  Body,      ///< Turns with the body's attitude: its axes are at rest.
  Momentum,  ///< Turned so that the angular momentum points along +y; at rest if it is conserved.
  /// Turns evenly, as the body would if nothing disturbed its spin: at the angular velocity that
  /// the motion starts with, without initial.tilt. The world's at the start.
  Turning,
};

/// The reference frame of one motion's pictures.
class MotionFrame {
 public:
  explicit MotionFrame(ReferenceFrame frame) : frame_(frame) {}
  /// Finds how fast ReferenceFrame::Turning turns. Throws InputError as
  /// physics::initialAngularVelocity() does.
  MotionFrame(ReferenceFrame frame, const physics::MotionSettings& motion);

  /// Returns the rotation from world axes to the frame's at this moment. Without angular momentum,
  /// ReferenceFrame::Momentum is the world's; where it points along -y, the rotation is about x.
  Eigen::Matrix3d fromWorld(const physics::Sample& sample) const;
  /// Returns `sample` with cage, attitude, angular velocity and angular momentum along the axes of
  /// the frame at its moment: quantities of the world, seen from the frame. Quantities without a
  /// direction are unchanged.
  physics::Sample seen(const physics::Sample& sample) const;

  /// Returns how the frame turns, along its own axes, about a body without torque that turns so.
  rigid::Turning turningAt(const rigid::Turning& body) const {
    return frame_ == ReferenceFrame::Body ? body : rigid::Turning{turning_};
  }
  /// Returns whether it turns at all, as seen from the world.
  bool turns() const { return frame_ == ReferenceFrame::Body || !turning_.isZero(0); }
  ReferenceFrame kind() const { return frame_; }

 private:
  ReferenceFrame frame_;
  Eigen::Vector3d turning_{0, 0, 0};
};

}  // namespace rotatebook::scene
