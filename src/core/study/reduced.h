// One number of a whole motion.
#pragma once

#include "physics/trajectory.h"
#include "scene/expectation.h"

namespace rotatebook::study {

/// Reduces a quantity of a whole motion to one number: half_turns to the number made, regime to the
/// last, ratios and stretch to the largest departure from 1, and others to the largest. diverges_at
/// is infinite.
double reduced(const physics::Trajectory& trajectory, scene::Measure measure);

}  // namespace rotatebook::study
