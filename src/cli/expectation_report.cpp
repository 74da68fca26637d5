#include "cli/expectation_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "base/number_text.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {
namespace {

// Of a measured number.
constexpr int kDigits = 7;

struct WordedBound {
  const char* words;
  std::optional<double> bound;
};

/// "at least 3, at most 4"
std::string expectedText(std::span<const WordedBound> bounds) {
  std::string text;
  for (const auto& [words, bound] : bounds) {
    if (bound) text += (text.empty() ? "" : ", ") + (words + shortestText(*bound));
  }
  return text;
}

std::string expectedText(const physics::Expectation& expectation) {
  return expectedText(std::array<WordedBound, 4>{{{"at least ", expectation.min},
                                                  {"at most ", expectation.max},
                                                  {"rises to ", expectation.risesTo},
                                                  {"falls to ", expectation.fallsTo}}});
}

const char* verdict(bool met) {
  return met ? "met    " : "UNMET  ";
}

std::string windowText(const physics::Expectation& expectation) {
  std::string text;
  if (expectation.from > 0) text += " from " + shortestText(expectation.from) + " s";
  if (std::isfinite(expectation.to)) text += " to " + shortestText(expectation.to) + " s";
  return text;
}

std::string measuredText(const physics::ExpectationResult& result) {
  if (std::isnan(result.lowest)) return "nothing: the motion has no sample there";
  if (std::isinf(result.lowest)) return "no divergence";
  if (result.lowest == result.highest) return roundedText(result.lowest, kDigits);
  return roundedText(result.lowest, kDigits) + " to " + roundedText(result.highest, kDigits);
}

bool expectsDivergence(std::span<const physics::Expectation> expectations) {
  return std::ranges::any_of(expectations, [](const physics::Expectation& expectation) {
    return expectation.quantity == physics::Quantity::DivergesAt;
  });
}

}  // namespace

std::string reportLine(const physics::ExpectationResult& result) {
  return verdict(result.met) + std::string(nameOf(result.expectation.quantity)) +
         windowText(result.expectation) + ": expected " + expectedText(result.expectation) +
         "; measured " + measuredText(result);
}

std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured) {
  const std::array<WordedBound, 2> worded{{{"at least ", bounds.min}, {"at most ", bounds.max}}};
  return verdict(bounds.hold(measured)) + subject + ": expected " + expectedText(worded) +
         "; measured " + (std::isnan(measured) ? "nothing" : roundedText(measured, kDigits));
}

int reportMotion(const physics::Trajectory& trajectory,
                 std::span<const physics::Expectation> expectations, std::ostream& out) {
  int status = kDone;
  if (trajectory.divergedAt) {
    const bool unexpected = !expectations.empty() && !expectsDivergence(expectations);
    out << (unexpected ? "  UNMET  no divergence is expected; " : "  ") << "the motion diverges at "
        << shortestText(*trajectory.divergedAt) << " s, after " << trajectory.samples.size()
        << " frames\n";
    if (unexpected) status = kUnmet;
  }
  for (const physics::ExpectationResult& result : check(trajectory, expectations)) {
    out << "  " << reportLine(result) << '\n';
    if (!result.met) status = kUnmet;
  }
  return status;
}

int sayIfUnmet(int status) {
  if (status == kUnmet) std::cerr << "rotatebook: expectations are unmet; the files were kept\n";
  return status;
}

}  // namespace rotatebook::cli
