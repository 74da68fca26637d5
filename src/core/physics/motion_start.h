// The inertia and the spin that a motion starts with.
#pragma once

#include <Eigen/Core>

#include "physics/inertia.h"
#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// The inertia of the model that `settings` ask for: the particles' own, or the rigid body's.
PrincipalAxes modelInertia(const MotionSettings& settings);
/// The angular velocity that the motion starts with. Throws InputError as InitialSpin::tilted()
/// does. [rad/s]
Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings);

}  // namespace rotatebook::physics
