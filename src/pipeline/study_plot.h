// Studies as pictures.
#pragma once

#include <string>

#include "pipeline/study.h"

namespace rotatebook::pipeline {

// What drawPlot() takes.

/// Two panels with logarithmic axes: the largest error against the step, and against the computing
/// time of one second of motion, with grey lines of the slopes that the fitted orders round to.
/// Runs without an end are left out. At least one run is whole.
std::string precisionPlot(const std::string& title, const PrecisionStudy& study);

/// Two panels: the interval measured and by the law, and their relative difference, both against
/// the tilt. At least one row has an interval.
std::string tiltPlot(const std::string& title, const TiltStudy& study);

}  // namespace rotatebook::pipeline
