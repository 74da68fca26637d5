// What a step costs. Inside the room only.
#pragma once

#include <cstdint>

#include "physics/motion_settings.h"

namespace rotatebook::diagnose {

/// Computing time of one integration step, the smallest of several measurements. [ns] It is the
/// running thread's own processor time, so that other programs and threads disturb it little; it
/// differs from run to run all the same. Steps through no more than the first `steps` >= 1 of the
/// motion, again and again; takes some milliseconds. Throws NoConvergence.
double nanosecondsPerStep(const physics::MotionSettings& settings, std::int64_t steps);

}  // namespace rotatebook::diagnose
