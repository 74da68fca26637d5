// Finds the throws of a recording by its rates alone. Inside the room only.
#pragma once

#include <vector>

#include "recording/flight.h"

namespace rotatebook::recording {

/// Returns the flights of a recording, in their order, without their ends: stretches of at least
/// 0.25 s, in which the body turns faster than 2 rad/s and moves as some free body does: with a
/// tensor I that a body may have, and the attitudes R that follow from the rates w, R I w stays
/// within 3 % (root mean square). Stretches are found where they keep it best, and grow from there
/// to either side.
std::vector<Range> flightsByRates(const InertialRecording& recording);

}  // namespace rotatebook::recording
