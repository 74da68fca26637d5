// Measurement of the time of an integration step. Inside the room only.
#pragma once

#include <cstdint>

#include "physics/motion_settings.h"

namespace rotatebook::diagnose {

/// Returns the computing time of one integration step, the smallest of several measurements. [ns]
/// It is the calling thread's processor time, which other programs and threads disturb little; it
/// differs from run to run all the same. Repeats the first `steps` >= 1 steps of the motion, or
/// fewer; takes some milliseconds. Throws StepError.
double nanosecondsPerStep(const physics::MotionSettings& settings, std::int64_t steps);

}  // namespace rotatebook::diagnose
