// Gaps in recordings. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "recording/gyroscope.h"

namespace rotatebook::recording {

/// Returns a sentence on the gaps between readings, from four usual steps on: how many there are,
/// the longest, and, if the rates `areIntegrated`, by how much the attitude after them may be off;
/// empty without gaps. The latter is the difference between the turn that integrateRates() finds in
/// a gap and that of the cubic with the slopes of the rates at both ends. `zero` is the time of a
/// reading at 0. [s]
std::string gapNote(const std::vector<Rate>& rates, double zero, bool areIntegrated);

}  // namespace rotatebook::recording
