#include "cli/expectation_report.h"

#include <iostream>

#include "base/number_text.h"
#include "cli/exit_code.h"
#include "scene/expectation_text.h"

namespace rotatebook::cli {
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

int reportMotion(const physics::Trajectory& trajectory,
                 std::span<const scene::Expectation> expectations, std::ostream& out) {
  int status = kDone;
  if (trajectory.divergedAt) {
    const bool unexpected = divergesUnexpectedly(trajectory, expectations);
    out << (unexpected ? "  UNMET  no divergence is expected; " : "  ") << "the motion diverges at "
        << shortestText(*trajectory.divergedAt) << " s, after " << trajectory.samples.size()
        << " frames\n";
    if (unexpected) status = kUnmet;
  }
  for (const scene::ExpectationResult& result : check(trajectory, expectations)) {
    out << "  " << reportLine(result) << '\n';
    if (!result.met) status = kUnmet;
  }
  return status;
}

int reportIfUnmet(int status) {
  if (status == kUnmet) std::cerr << "rotatebook: expectations are unmet; the files were kept\n";
  return status;
}

}  // namespace rotatebook::cli
