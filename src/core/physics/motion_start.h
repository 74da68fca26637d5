// The inertia and the spin that a motion starts with.
#pragma once

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Returns the inertia of the model in `settings`: of the particles, or of the rigid body.
rigid::PrincipalAxes modelInertia(const MotionSettings& settings);
/// Returns the angular velocity at t = 0, in body axes. Throws InputError as InitialSpin::tilted()
/// does. [rad/s]
Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings);
/// Returns the exact motion of the model's body if it were rigid, with all nudges. Throws
/// InputError likewise.
NudgedRotation exactRotation(const MotionSettings& settings);

}  // namespace rotatebook::physics
