// The factory of simulators.
#pragma once

#include <memory>

#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Creates the simulator that `settings` specify, at t = 0. Throws InputError as
/// InitialSpin::tilted() and requireSameLayout() do, if the model doesn't have the integrator, if
/// a rigid model's integrator doesn't take the dissipation, and if a recording hasn't been read.
std::unique_ptr<Simulator> makeSimulator(const MotionSettings& settings);

}  // namespace rotatebook::physics
