// The paper's second and third way: a rigid body whose attitude is a matrix or a quaternion.
#pragma once

#include <memory>

#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// A free rigid body for Model::Matrix or Model::Quaternion, with any of their integrators. If
/// normalised, each step ends with the nearest attitude that is orthogonal or of unit norm. Drawn
/// by the map that the attitude stands for, be it a rotation or not. Throws InputError as
/// makeSimulator() does.
std::unique_ptr<Simulator> makeRigidSimulator(const MotionSettings& settings);

}  // namespace rotatebook::physics
