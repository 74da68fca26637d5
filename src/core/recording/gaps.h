// Steps and gaps between readings. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recording/gyroscope.h"

namespace rotatebook::recording {

/// Returns the median of the steps between at least two times. [s]
double medianStep(const std::vector<double>& times);

/// Returns a sentence on the gaps between readings, from four usual steps on: how many there are,
/// the longest, and, if the rates `areIntegrated`, by how much the attitude after them may be off;
/// empty without gaps. The latter is the difference between the turn that integrateRates() finds in
/// a gap and that of the cubic with the slopes of the rates at both ends. `zero` is the time of a
/// reading at 0. [s]
std::string gapNote(const std::vector<Rate>& rates, double zero, bool areIntegrated);

/// Returns the sum of these differences over all gaps and all steps in which the body turns by more
/// than 0.3 rad. [rad]
double unknownTurnIn(const std::vector<Rate>& rates);

/// Returns the readings after such gaps in which the body turns by more than 0.5 rad: across them
/// its attitude isn't known to a degree.
std::vector<std::size_t> breaksIn(const std::vector<Rate>& rates);

}  // namespace rotatebook::recording
