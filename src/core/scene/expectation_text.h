// Expectations and their measured values as text.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "physics/trajectory.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// Returns the bounds: "at least 3, at most 4".
std::string expectedText(const Expectation& expectation);

/// Returns the window, " from 3 s to 4.5 s"; empty for the whole motion.
std::string windowText(const Expectation& expectation);

/// Default number of significant digits of a measured value.
inline constexpr int kMeasuredDigits = 7;

/// Returns the measured range: "0.02 to 1.31", "no divergence", or why there is nothing to measure.
/// Numbers have at most `digits` significant digits, or as many more as they need to stay on their
/// side of each bound.
std::string measuredText(const ExpectationResult& result, int digits = kMeasuredDigits);

/// Returns one number that `bounds` apply to, rounded in the same way; "nothing" for NaN.
std::string measuredText(double value, const Expectation& bounds, int digits = kMeasuredDigits);

/// Returns one number that bounds apply to as a JSON object: {"quantity": `subject`, "meaning",
/// "min", "max", "measured", "met"}; infinity is "inf", NaN null.
std::string boundsJson(const std::string& subject, std::string_view meaning, const Bounds& bounds,
                       double measured);

/// Returns whether the motion diverges although it has expectations, none of them on diverges_at.
bool divergesUnexpectedly(const physics::Trajectory& trajectory,
                          std::span<const Expectation> expectations);

}  // namespace rotatebook::scene
