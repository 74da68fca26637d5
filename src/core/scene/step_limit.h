// Limits of a motion's steps. Inside the room only.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rotatebook::scene {

/// Returns the setting with which no step is longer than `longest`, and "or "; empty if there is
/// none. [s]
std::string shorterSteps(const physics::SimulationSettings& simulation, double longest);

/// Throws InputError if a step is longer than the fastest decay of a sink of energy, 1/k: Euler's
/// steps pass the end then, as their factor 1 - h k is negative, and diverge from h k = 2 on, Runge
/// and Kutta's from 2.785. Measured of the starter's book: 2.0 and 2.78 near the end, while from
/// elsewhere rk4 loses L from 1.34 on; of six other bodies it keeps L to 0.0012 at 1.
void requireSlowSink(const Motion& motion);

}  // namespace rotatebook::scene
