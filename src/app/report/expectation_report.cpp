#include "report/expectation_report.h"

#include "base/number_text.h"
#include "scene/expectation_text.h"

namespace rotatebook::report {
namespace {

const char* verdict(bool met) {
  return met ? "met    " : "UNMET  ";
}

}  // namespace

std::string reportLine(const scene::ExpectationResult& result) {
  return verdict(result.met) + std::string(nameOf(result.expectation.quantity)) +
         windowText(result.expectation) + ": expected " + expectedText(result.expectation) +
         "; measured " + measuredText(result);
}

std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured) {
  const scene::Expectation expectation{.min = bounds.min, .max = bounds.max};
  return verdict(bounds.hold(measured)) + subject + ": expected " + expectedText(expectation) +
         "; measured " + measuredText(measured, expectation);
}

bool reportMotion(const physics::Trajectory& trajectory,
                  std::span<const scene::Expectation> expectations, std::ostream& out) {
  bool met = true;
  if (trajectory.divergedAt) {
    const bool unexpected = divergesUnexpectedly(trajectory, expectations);
    out << (unexpected ? "  UNMET  no divergence is expected; " : "  ") << "the motion diverges at "
        << shortestText(*trajectory.divergedAt) << " s, after " << trajectory.samples.size()
        << " frames\n";
    met = !unexpected;
  }
  for (const scene::ExpectationResult& result : check(trajectory, expectations)) {
    out << "  " << reportLine(result) << '\n';
    met = met && result.met;
  }
  return met;
}

}  // namespace rotatebook::report
