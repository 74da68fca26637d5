// The pieces of a motion in which its body moves freely. Inside the room only.
#pragma once

#include <span>
#include <vector>

#include "physics/nudge.h"
#include "physics/trajectory.h"

namespace rotatebook::timeline {

/// Returns the samples from one nudge to the next, each piece with the samples just after its
/// nudge; pieces without samples are left out. The spans refer to `trajectory`.
std::vector<std::span<const physics::Sample>> freePieces(const physics::Trajectory& trajectory,
                                                         std::span<const physics::Nudge> nudges);

}  // namespace rotatebook::timeline
