// Expected against measured, in words. Inside the room only.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "physics/trajectory.h"
#include "scene/expectation.h"
#include "scene/study_settings.h"

namespace rotatebook::cli {

/// One line: "met    tilt_deg: expected at most 1.5; measured 0.02 to 1.31".
std::string reportLine(const scene::ExpectationResult& result);

/// The same of a single number: "met    order of rk4: expected at least 3.9; measured 4.01".
/// "nothing" is measured if it is NaN.
std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured);

/// Prints what became of a motion to `out`: its divergence if any, and a line an expectation.
/// Returns kDone if all are met, else kUnmet: also where a motion diverges that has expectations,
/// but none of that.
int reportMotion(const physics::Trajectory& trajectory,
                 std::span<const scene::Expectation> expectations, std::ostream& out);

/// Passes `status` on, with a line on the standard error if it is kUnmet.
int reportIfUnmet(int status);

}  // namespace rotatebook::cli
