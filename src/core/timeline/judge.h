// Judges motions.
#pragma once

#include "physics/motion_settings.h"
#include "physics/trajectory.h"
#include "timeline/verdict.h"

namespace rotatebook::timeline {

/// Judges `trajectory`, which was simulated or recorded from `motion`. Of recordings whose spins
/// are uncertain, slopes of attitudes or noisy, the start of the exact motion is fitted within that
/// uncertainty, too; regimes and half-turns that are due come from fits and means then. A recording
/// is judged without its flaws, if it has any, and one that doesn't agree by its attitudes alone if
/// its rates aren't their slopes. Throws InputError as physics::simulate() does.
Verdict judge(const physics::MotionSettings& motion, const physics::Trajectory& trajectory);

}  // namespace rotatebook::timeline
