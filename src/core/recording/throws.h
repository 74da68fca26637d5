// Finds the throws of a recording by its rates alone. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "recording/flight.h"

namespace rotatebook::recording {

/// A stretch of a recording in which the body turns fast.
struct FastStretch {
  Range range;
  Range run;              ///< The fast readings around it.
  std::string problem{};  ///< Why it is no flight; empty for a flight.
};

/// Returns the flights of a recording, without their ends: stretches of at least 0.25 s, in which
/// the body turns faster than 2 rad/s and moves as some free body does: with a tensor I that a body
/// may nearly have, and the attitudes R that follow from the rates w, R I w stays within 3 % (root
/// mean square). Stretches are found where they keep it best, and grow from there to either side,
/// across gaps where a free motion leads. Of fast stretches without a flight the whole is returned,
/// with the reason, and beside a flight what would be one but for its moments. All are in their
/// order.
std::vector<FastStretch> fastStretches(const InertialRecording& recording);

}  // namespace rotatebook::recording
