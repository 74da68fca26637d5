#include "scene/expectation_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::scene {
namespace {

// Enough to distinguish any two doubles.
constexpr int kMaxDigits = 17;

struct LabelledBound {
  const char* label;
  std::optional<double> bound;
};

/// Returns whether `shown` meets and misses the same bounds as `value`.
bool meetsSameBounds(double shown, double value, const Expectation& bounds) {
  const auto below = [&](const std::optional<double>& bound) {
    return bound && (shown < *bound) != (value < *bound);
  };
  const auto above = [&](const std::optional<double>& bound) {
    return bound && (shown > *bound) != (value > *bound);
  };
  return !below(bounds.min) && !below(bounds.risesTo) && !above(bounds.max) &&
         !above(bounds.fallsTo);
}

double numberIn(const std::string& text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

std::string expectedText(const Expectation& expectation) {
  const std::array<LabelledBound, 4> bounds{{{"at least ", expectation.min},
                                             {"at most ", expectation.max},
                                             {"rises to ", expectation.risesTo},
                                             {"falls to ", expectation.fallsTo}}};
  return joinedOf(bounds, [](const LabelledBound& one) {
    return one.bound ? one.label + shortestText(*one.bound) : "";
  });
}

std::string windowText(const Expectation& expectation) {
  std::string text;
  if (expectation.from > 0) text += " from " + shortestText(expectation.from) + " s";
  if (std::isfinite(expectation.to)) text += " to " + shortestText(expectation.to) + " s";
  return text;
}

std::string measuredText(const ExpectationResult& result, int digits) {
  if (std::isnan(result.lowest)) return "nothing: the motion has no sample there";
  if (std::isinf(result.lowest)) return "no divergence";
  const std::string lowest = measuredText(result.lowest, result.expectation, digits);
  const std::string highest = measuredText(result.highest, result.expectation, digits);
  const std::string range = lowest == highest ? lowest : lowest + " to " + highest;
  if (!result.endsEarly) return range;
  return range + ", but the motion ends at " + roundedText(*result.endsEarly, digits) + " s";
}

std::string measuredText(double value, const Expectation& bounds, int digits) {
  if (std::isnan(value)) return "nothing";
  std::string text = roundedText(value, digits);
  while (digits < kMaxDigits && !meetsSameBounds(numberIn(text), value, bounds)) {
    text = roundedText(value, ++digits);
  }
  return text;
}

std::string boundsJson(const std::string& subject, std::string_view meaning, const Bounds& bounds,
                       double measured) {
  JsonObject object;
  object.addString("quantity", subject)
      .addString("meaning", meaning)
      .addNumberOrNull("min", bounds.min)
      .addNumberOrNull("max", bounds.max);
  if (std::isinf(measured))
    object.addString("measured", "inf");
  else
    object.addNumber("measured", measured);
  return object.addBool("met", bounds.hold(measured)).text();
}

bool divergesUnexpectedly(const physics::Trajectory& trajectory,
                          std::span<const Expectation> expectations) {
  return trajectory.divergedAt && !expectations.empty() &&
         std::ranges::none_of(expectations, [](const Expectation& expectation) {
           return expectation.measure == Measure::DivergesAt;
         });
}

}  // namespace rotatebook::scene
