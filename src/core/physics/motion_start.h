// The inertia and the spin that a motion starts with.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Returns the inertia of the model in `settings`: of the particles, or of the rigid body.
rigid::PrincipalAxes modelInertia(const MotionSettings& settings);
/// Gives a motion a body of this inertia about its centre, in body axes. [kg m^2] Throws InputError
/// as rigid::checkedInertia() does.
void takeInertia(MotionSettings& settings, const Eigen::Matrix3d& tensor);
/// Returns the angular velocity at t = 0, in body axes. Throws InputError as InitialSpin::tilted()
/// does. [rad/s]
Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings);
/// Returns the rotation from the body's axes to the world's at t = 0; nullopt if none is stated.
std::optional<Eigen::Matrix3d> initialAttitude(const InitialSpin& initial);
/// Returns the same motion as it is where body and world axes coincide at t = 0: without an
/// attitude, and with its nudges turned back.
MotionSettings withoutAttitude(MotionSettings settings);
/// Returns the rate of the fastest decay that a sink of energy makes, 0 without one: of a wobble
/// about the spin in which it ends, with the moments I1 <= I2 <= I3 the greater of
///
///     eps L^2 (1/I1 - 1/I3) / I2^2   and   eps L^2 (1/I2 - 1/I3) / I1^2.
///
/// Other directions of L have slower ones. L is as large as the start and the nudges together can
/// make it. [1/s] Throws InputError likewise.
double fastestDissipation(const MotionSettings& settings);
/// Returns the exact motion of the model's body if it were rigid, with all nudges. Throws
/// InputError likewise.
NudgedRotation exactRotation(const MotionSettings& settings);

}  // namespace rotatebook::physics
