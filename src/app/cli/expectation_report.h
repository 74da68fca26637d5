// Reports of expected and measured values, as text and as JSON. Inside the room only.
#pragma once

#include <ostream>
#include <string>

#include "scene/expectation.h"
#include "scene/study_settings.h"
#include "timeline/motion_summary.h"

namespace rotatebook::cli {

/// Returns one line: "met      tilt_deg: expected at most 1.5; measured 0.02 to 1.31".
std::string reportLine(const scene::ExpectationResult& result);

/// Returns such a line for one number: "met      order of rk4: expected at least 3.9;
/// measured 4.01". A NaN is printed as "nothing".
std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured);

/// Prints a motion's divergence, if any, and a line for each of its expectations to `out`.
void reportExpectations(const timeline::MotionSummary& summary, std::ostream& out);

}  // namespace rotatebook::cli
