// Plots the results of studies.
#pragma once

#include <string>

#include "study/study.h"
#include "study/sweep.h"

namespace rotatebook::picture {

// Each function returns commands for drawPlot().

/// Plots on two panels with logarithmic axes the largest error over the step, and over the
/// computing time of one second of motion, with grey lines whose slopes are the rounded fitted
/// orders. Runs that didn't complete are left out; at least one run must have.
std::string precisionPlot(const std::string& title, const study::PrecisionStudy& study);

/// Plots on two panels over the tilt the flip interval, measured and by the logarithmic law, and
/// their relative difference. At least one row must have an interval.
std::string tiltPlot(const std::string& title, const study::TiltStudy& study);

/// Plots each measured quantity on a panel over the key that is varied, one curve for each value of
/// the second key. Axes over wide spans are logarithmic; a motion that doesn't diverge is an open
/// triangle at the end of its run.
std::string sweepPlot(const std::string& title, const study::SweepStudy& study,
                      const scene::Sweep& sweep);

}  // namespace rotatebook::picture
