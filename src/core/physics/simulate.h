// Simulation of a whole motion.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Simulates `sampleCount` >= 1 samples, or fewer if the motion diverges. Throws InputError as
/// makeSimulator() does, and if the spin is so large that not even the first sample is finite;
/// StepError if an integrator can't make its steps. If `stop` isn't null and another thread sets
/// it, the simulation ends after a sample, and its result must be discarded.
Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop = nullptr);

/// Simulates likewise one sample for each of `times`, at least one, the first 0 and in their order.
/// [s] The steps are those of samples at even times; a sample between two steps is made from a copy
/// of the simulator that goes on by a shorter step, so that no sample changes the motion.
Trajectory simulate(const MotionSettings& settings, std::span<const double> times,
                    const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::physics
