// Studies as pictures.
#pragma once

#include <string>

#include "study/study.h"

namespace rotatebook::picture {

// What drawPlot() takes.

/// Two panels with logarithmic axes: the largest error against the step, and against the computing
/// time of one second of motion, with grey lines of the slopes that the fitted orders round to.
/// Runs without an end are left out. At least one run is whole.
std::string precisionPlot(const std::string& title, const study::PrecisionStudy& study);

/// Two panels: the interval measured and by the law, and their relative difference, both against
/// the tilt. At least one row has an interval.
std::string tiltPlot(const std::string& title, const study::TiltStudy& study);

}  // namespace rotatebook::picture
