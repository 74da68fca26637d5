// From the settings of a motion to its trajectory.
#pragma once

#include <atomic>
#include <cstdint>

#include "physics/layout.h"
#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Simulates `sampleCount` >= 1 samples, fewer if the motion diverges. Throws InputError if the
/// initial spin can't be tilted as asked, or is so large that not even the first sample is finite;
/// NoConvergence if an implicit integrator finds no solution for its steps. `stop`, if not null and
/// set from outside, ends it after a sample: what is returned is then of no use. `caller` is left
/// to its default: a program built with another layout is refused with an InputError.
Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop = nullptr, const Layout& caller = layoutHere());

}  // namespace rotatebook::physics
