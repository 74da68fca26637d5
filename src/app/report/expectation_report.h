// Lines that report expected and measured values. Inside the room only.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "physics/trajectory.h"
#include "scene/expectation.h"
#include "scene/study_settings.h"

namespace rotatebook::report {

/// Returns one line: "met    tilt_deg: expected at most 1.5; measured 0.02 to 1.31".
std::string reportLine(const scene::ExpectationResult& result);

/// Returns such a line for one number: "met    order of rk4: expected at least 3.9; measured 4.01".
/// A NaN is printed as "nothing".
std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured);

/// Prints a motion's divergence, if any, and a line for each of its expectations to `out`. Returns
/// whether all are met; also false if the motion diverges and has expectations, but none of that.
bool reportMotion(const physics::Trajectory& trajectory,
                  std::span<const scene::Expectation> expectations, std::ostream& out);

}  // namespace rotatebook::report
