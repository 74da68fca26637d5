#include "study/study_csv.h"

#include <cmath>

#include "base/number_text.h"
#include "scene/names.h"

namespace rotatebook::study {
namespace {

std::string field(double value) {
  return "," + (std::isnan(value) ? "" : shortestText(value));
}

// Of a measured time the tenth of a nanosecond says more than enough. NaN stays NaN.
double tenths(double nanoseconds) {
  return std::round(nanoseconds * 10) / 10;
}

std::string word(physics::Integrator integrator) {
  return std::string(scene::nameOf(scene::kIntegrators, integrator));
}

std::string precisionLine(const PrecisionRow& row) {
  const bool whole = row.end.kind == RunEnd::Kind::Whole;
  return word(row.integrator) + field(row.h) + "," + std::to_string(row.steps) +
         field(row.errorDeg) + field(row.finalErrorDeg) + field(row.energyDrift) +
         field(row.momentumDrift) + "," + (whole ? std::to_string(row.halfTurns) : "") +
         field(tenths(row.nsPerStep)) + "," + row.end.text() + "\n";
}

}  // namespace

std::string precisionCsv(const PrecisionStudy& study) {
  std::string text =
      "integrator,h_s,steps,error_deg,final_error_deg,energy_drift,L_drift,half_turns,ns_per_step,"
      "status\n";
  for (const PrecisionRow& row : study.rows) text += precisionLine(row);
  return text;
}

std::string ordersCsv(const PrecisionStudy& study) {
  std::string text = "integrator,order,runs,shortest_h_s,longest_h_s\n";
  for (const auto& [integrator, fit] : study.orders) {
    const bool none = fit.runs == 0;
    text += word(integrator) + field(fit.order) + "," + std::to_string(fit.runs) +
            field(none ? kNoNumber : fit.shortest) + field(none ? kNoNumber : fit.longest) + "\n";
  }
  return text;
}

std::string tiltCsv(const TiltStudy& study) {
  std::string text = "tilt_rad,flips,interval_s,law_s,ratio,status\n";
  for (const TiltRow& row : study.rows) {
    const bool ran = row.end.kind == RunEnd::Kind::Whole || row.end.kind == RunEnd::Kind::FewFlips;
    text += shortestText(row.tilt) + "," + (ran ? std::to_string(row.flips) : "") +
            field(row.interval) + field(row.law) + field(row.ratio()) + "," + row.end.text() + "\n";
  }
  return text;
}

}  // namespace rotatebook::study
