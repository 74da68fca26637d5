// Simulation of a whole motion.
#pragma once

#include <atomic>
#include <cstdint>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Simulates `sampleCount` >= 1 samples, or fewer if the motion diverges. Throws InputError as
/// makeSimulator() does, and if the spin is so large that not even the first sample is finite;
/// StepError if an integrator can't make its steps. If `stop` isn't null and another thread sets
/// it, the simulation ends after a sample, and its result must be discarded.
Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::physics
