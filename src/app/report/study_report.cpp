#include "report/study_report.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"
#include "report/expectation_report.h"
#include "report/formatted.h"
#include "scene/names.h"

namespace rotatebook::report {
namespace {

using study::PrecisionRow;
using study::RunEnd;

std::string name(physics::Integrator integrator) {
  return std::string(scene::nameOf(scene::kIntegrators, integrator));
}

std::string orderLine(const study::IntegratorOrder& order) {
  const study::OrderFit& fit = order.fit;
  std::string line = formatted("%-16s ", name(order.integrator).c_str());
  if (std::isnan(fit.order)) {
    return line + "no order: " + std::to_string(fit.runs) + " usable runs, " +
           std::to_string(study::kMinRuns) + " needed";
  }
  return line + formatted("order %5.2f from %2d runs, steps of %.3g to %.3g s", fit.order, fit.runs,
                          fit.shortest, fit.longest);
}

/// Returns "euler: 3 of 11 runs diverged"; empty if no run ended like that.
std::string failureLine(const study::PrecisionStudy& result, physics::Integrator integrator,
                        RunEnd::Kind kind, const char* outcome) {
  const auto runs = std::ranges::count(result.rows, integrator, &PrecisionRow::integrator);
  const auto failed = std::ranges::count_if(result.rows, [&](const PrecisionRow& row) {
    return row.integrator == integrator && row.end.kind == kind;
  });
  if (failed == 0) return "";
  return "  " + name(integrator) + ": " + std::to_string(failed) + " of " + std::to_string(runs) +
         " runs " + outcome + "\n";
}

double orderOf(const study::PrecisionStudy& result, physics::Integrator integrator) {
  const auto found =
      std::ranges::find(result.orders, integrator, &study::IntegratorOrder::integrator);
  return found->fit.order;
}

std::string tiltLine(const study::TiltRow& row) {
  const std::string start = formatted("tilt %-7.3g ", row.tilt);
  if (row.end.kind != RunEnd::Kind::Whole) return start + row.end.text();
  return start + formatted("%3d flips, one every %.5g s; the law says %.5g s", row.flips,
                           row.interval, row.law);
}

/// Prints the line of an expectation; returns whether it is met.
bool reportBounds(const std::string& subject, const scene::Bounds& bounds, double measured,
                  std::ostream& out) {
  out << "  " << reportLine(subject, bounds, measured) << '\n';
  return bounds.hold(measured);
}

}  // namespace

bool reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                 std::ostream& out) {
  for (const study::IntegratorOrder& order : result.orders) out << "  " << orderLine(order) << '\n';
  for (const study::IntegratorOrder& order : result.orders) {
    out << failureLine(result, order.integrator, RunEnd::Kind::Diverged, "diverged")
        << failureLine(result, order.integrator, RunEnd::Kind::NoConvergence,
                       "found no solution for their steps");
  }
  bool met = true;
  for (const auto& [integrator, bounds] : study.orders) {
    met &= reportBounds("order of " + name(integrator), bounds, orderOf(result, integrator), out);
  }
  return met;
}

bool reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                 std::ostream& out) {
  for (const study::TiltRow& row : result.rows) out << "  " << tiltLine(row) << '\n';
  if (!study.flipLaw) return true;
  return reportBounds("flip_law", *study.flipLaw, result.greatestDeviation(), out);
}

}  // namespace rotatebook::report
