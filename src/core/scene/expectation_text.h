// Expectations and their measured values as text.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "physics/trajectory.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// Returns a text in another language by its English, in which names in {} stand for numbers.
using Say = std::function<std::string(std::string_view english)>;
inline std::string sayInEnglish(std::string_view english) {
  return std::string(english);
}

/// Returns the bounds: "at least 3, at most 4".
std::string expectedText(const Expectation& expectation, const Say& say = sayInEnglish);

/// Returns the window, " from 3 s to 4.5 s"; empty for the whole motion.
std::string windowText(const Expectation& expectation, const Say& say = sayInEnglish);

/// Default number of significant digits of a measured value.
inline constexpr int kMeasuredDigits = 7;

/// Returns the measured range: "0.02 to 1.31", "no divergence", or why there is nothing to measure.
/// Numbers have at most `digits` significant digits, or as many more as they need to stay on their
/// side of each bound.
std::string measuredText(const ExpectationResult& result, int digits = kMeasuredDigits,
                         const Say& say = sayInEnglish);

/// Returns one number that `bounds` apply to, rounded in the same way; "nothing" for NaN.
std::string measuredText(double value, const Expectation& bounds, int digits = kMeasuredDigits,
                         const Say& say = sayInEnglish);

/// Returns whether the motion diverges although it has expectations, none of them on diverges_at.
bool divergesUnexpectedly(const physics::Trajectory& trajectory,
                          std::span<const Expectation> expectations);

}  // namespace rotatebook::scene
