#include "scene/expectation_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::scene {
namespace {

// Enough to distinguish any two doubles.
constexpr int kMaxDigits = 17;

struct LabelledBound {
  std::string text;
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

std::string expectedText(const Expectation& expectation, const Say& say) {
  const std::array<LabelledBound, 4> bounds{{{say("at least {number}"), expectation.min},
                                             {say("at most {number}"), expectation.max},
                                             {say("rises to {number}"), expectation.risesTo},
                                             {say("falls to {number}"), expectation.fallsTo}}};
  return joinedOf(bounds, [&](const LabelledBound& one) {
    return one.bound ? filledIn(one.text, {{"number", shortestText(*one.bound)}}) : "";
  });
}

std::string windowText(const Expectation& expectation, const Say& say) {
  const auto part = [](const std::string& words, double time) {
    return " " + filledIn(words, {{"time", shortestText(time)}});
  };
  std::string text;
  if (expectation.from > 0) text += part(say("from {time} s"), expectation.from);
  if (std::isfinite(expectation.to)) text += part(say("to {time} s"), expectation.to);
  return text;
}

std::string measuredText(const ExpectationResult& result, int digits, const Say& say) {
  if (std::isnan(result.lowest)) return say("nothing: the motion has no sample there");
  if (std::isinf(result.lowest)) return say("no divergence");
  const std::string lowest = measuredText(result.lowest, result.expectation, digits, say);
  const std::string highest = measuredText(result.highest, result.expectation, digits, say);
  const std::string range =
      lowest == highest ? lowest
                        : filledIn(say("{low} to {high}"), {{"low", lowest}, {"high", highest}});
  if (!result.endsEarly) return range;
  return filledIn(say("{range}, but the motion ends at {time} s"),
                  {{"range", range}, {"time", roundedText(*result.endsEarly, digits)}});
}

std::string measuredText(double value, const Expectation& bounds, int digits, const Say& say) {
  if (std::isnan(value)) return say("nothing");
  std::string text = roundedText(value, digits);
  while (digits < kMaxDigits && !meetsSameBounds(numberIn(text), value, bounds)) {
    text = roundedText(value, ++digits);
  }
  return text;
}

bool divergesUnexpectedly(const physics::Trajectory& trajectory,
                          std::span<const Expectation> expectations) {
  return trajectory.divergedAt && !expectations.empty() &&
         std::ranges::none_of(expectations, [](const Expectation& expectation) {
           return expectation.measure == Measure::DivergesAt;
         });
}

}  // namespace rotatebook::scene
