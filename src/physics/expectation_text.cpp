#include "physics/expectation_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/number_text.h"

namespace rotatebook::physics {
namespace {

// Of a measured number.
constexpr int kDigits = 7;

struct WordedBound {
  const char* words;
  std::optional<double> bound;
};

}  // namespace

std::string expectedText(const Expectation& expectation) {
  const std::array<WordedBound, 4> bounds{{{"at least ", expectation.min},
                                           {"at most ", expectation.max},
                                           {"rises to ", expectation.risesTo},
                                           {"falls to ", expectation.fallsTo}}};
  std::string text;
  for (const auto& [words, bound] : bounds) {
    if (bound) text += (text.empty() ? "" : ", ") + (words + shortestText(*bound));
  }
  return text;
}

std::string windowText(const Expectation& expectation) {
  std::string text;
  if (expectation.from > 0) text += " from " + shortestText(expectation.from) + " s";
  if (std::isfinite(expectation.to)) text += " to " + shortestText(expectation.to) + " s";
  return text;
}

std::string measuredText(const ExpectationResult& result) {
  if (std::isnan(result.lowest)) return "nothing: the motion has no sample there";
  if (std::isinf(result.lowest)) return "no divergence";
  if (result.lowest == result.highest) return measuredText(result.lowest);
  return measuredText(result.lowest) + " to " + measuredText(result.highest);
}

std::string measuredText(double value) {
  return std::isnan(value) ? "nothing" : roundedText(value, kDigits);
}

bool divergesUnexpectedly(const Trajectory& trajectory, std::span<const Expectation> expectations) {
  return trajectory.divergedAt && !expectations.empty() &&
         std::ranges::none_of(expectations, [](const Expectation& expectation) {
           return expectation.quantity == Quantity::DivergesAt;
         });
}

}  // namespace rotatebook::physics
