#include "cli/expectation_report.h"

#include <cmath>

#include "base/number_text.h"
#include "scene/expectation_text.h"

namespace rotatebook::cli {
namespace {

const char* verdict(bool met) {
  return met ? "met      " : "not met  ";
}

}  // namespace

std::string reportLine(const scene::ExpectationResult& result) {
  return verdict(result.met) + std::string(nameOf(result.expectation.measure)) +
         windowText(result.expectation) + ": expected " + expectedText(result.expectation) +
         "; measured " + measuredText(result);
}

std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured) {
  const scene::Expectation expectation{.min = bounds.min, .max = bounds.max};
  return verdict(bounds.hold(measured)) + subject + ": expected " + expectedText(expectation) +
         "; measured " + measuredText(measured, expectation);
}

void reportExpectations(const timeline::MotionSummary& summary, std::ostream& out) {
  if (summary.divergedAt) {
    out << (summary.divergesUnexpectedly ? "  not met  no divergence is expected; " : "  ")
        << "the motion diverges at " << shortestText(std::round(*summary.divergedAt * 1e4) / 1e4)
        << " s, after " << summary.frames << " frames\n";
  }
  for (const scene::ExpectationResult& result : summary.expectations) {
    out << "  " << reportLine(result) << '\n';
  }
}

}  // namespace rotatebook::cli
