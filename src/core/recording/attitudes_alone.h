// A recording's motion by its attitudes alone.
#pragma once

#include <vector>

#include "recording/recorded_motion.h"

namespace rotatebook::recording {

/// Returns SpinFacts::uncertainty of slopes.
double slopeUncertainty(const std::vector<RecordedMoment>& moments);

/// Returns the motion with the slopes of its attitudes in the place of its spins.
RecordedMotion attitudesAlone(const RecordedMotion& motion);

}  // namespace rotatebook::recording
