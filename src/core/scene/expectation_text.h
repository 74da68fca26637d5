// Expectations and what was measured for them, in words.
#pragma once

#include <span>
#include <string>

#include "physics/trajectory.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// "at least 3, at most 4"
std::string expectedText(const Expectation& expectation);

/// " from 3 s to 4.5 s", or empty for the whole motion.
std::string windowText(const Expectation& expectation);

/// Significant digits of a measured number, where nothing else is asked for.
inline constexpr int kMeasuredDigits = 7;

/// "0.02 to 1.31", "no divergence", or why there is nothing to measure. Numbers have `digits`
/// significant digits at most, or as many more as it takes to stay on their side of each bound.
std::string measuredText(const ExpectationResult& result, int digits = kMeasuredDigits);

/// One number that `bounds` are on, in the same way; "nothing" if it is NaN.
std::string measuredText(double value, const Expectation& bounds, int digits = kMeasuredDigits);

/// Whether a motion diverges that has expectations, but none of that.
bool divergesUnexpectedly(const physics::Trajectory& trajectory,
                          std::span<const Expectation> expectations);

}  // namespace rotatebook::scene
