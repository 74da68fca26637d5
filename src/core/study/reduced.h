// One number of a whole motion. Inside the room only.
#pragma once

#include "physics/motion_settings.h"
#include "physics/trajectory.h"
#include "scene/measure.h"

namespace rotatebook::study {

/// Reduces a motion, the trajectory of `motion`, to one number: half_turns to the number made,
/// regime to the last, ratios and stretch to the largest departure from 1, others to the largest,
/// and order to the largest error. Where nothing of the kind happens, it is kNever.
double reduced(const physics::Trajectory& trajectory, const physics::MotionSettings& motion,
               scene::Measure measure);

}  // namespace rotatebook::study
