#include "study/study_csv.h"

#include <cmath>

#include "base/number_text.h"
#include "scene/names.h"

namespace rotatebook::study {
namespace {

// Returns a number as a field after others; empty for NaN.
std::string field(double value) {
  return "," + (std::isnan(value) ? "" : shortestText(value));
}

// Rounds to tenths of a nanosecond, finer than any measurement. NaN stays NaN.
double roundedToTenths(double nanoseconds) {
  return std::round(nanoseconds * 10) / 10;
}

std::string nameOf(physics::Integrator integrator) {
  return std::string(scene::nameOf(scene::kIntegrators, integrator));
}

std::string precisionLine(const PrecisionRow& row) {
  const bool whole = row.end.kind == RunEnd::Kind::Whole;
  return nameOf(row.integrator) + field(row.h) + "," + std::to_string(row.steps) +
         field(row.errorDeg) + field(row.finalErrorDeg) + field(row.energyDrift) +
         field(row.momentumDrift) + "," + (whole ? std::to_string(row.halfTurns) : "") +
         field(roundedToTenths(row.nsPerStep)) + "," + row.end.text() + "\n";
}

const std::string kStatusColumn = ",status";

}  // namespace

bool isStudyHeader(std::string_view row) {
  return row.ends_with(kStatusColumn);
}

std::string precisionCsv(const PrecisionStudy& study) {
  std::string text =
      "integrator,h_s,steps,error_deg,final_error_deg,energy_drift,L_drift,half_turns,ns_per_step" +
      kStatusColumn + "\n";
  for (const PrecisionRow& row : study.rows) text += precisionLine(row);
  return text;
}

std::string ordersCsv(const PrecisionStudy& study) {
  std::string text = "integrator,order,runs,shortest_h_s,longest_h_s\n";
  for (const auto& [integrator, fit] : study.orders) {
    const bool none = fit.runs == 0;
    text += nameOf(integrator) + field(fit.order) + "," + std::to_string(fit.runs) +
            field(none ? kNoNumber : fit.shortest) + field(none ? kNoNumber : fit.longest) + "\n";
  }
  return text;
}

std::string tiltCsv(const TiltStudy& study) {
  std::string text = "tilt_rad,flips,interval_s,law_s,ratio" + kStatusColumn + "\n";
  for (const TiltRow& row : study.rows) {
    const bool ran = row.end.kind == RunEnd::Kind::Whole || row.end.kind == RunEnd::Kind::FewFlips;
    text += shortestText(row.tilt) + "," + (ran ? std::to_string(row.flips) : "") +
            field(row.interval) + field(row.law) + field(row.ratio()) + "," + row.end.text() + "\n";
  }
  return text;
}

/// Returns a field of a CSV, in quotes if it needs them. (RFC 4180)
std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"") == text.npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string sweepCsv(const SweepStudy& result, const scene::Sweep& sweep) {
  std::string text = sweep.x.key;
  if (sweep.curves) text += "," + sweep.curves->key;
  for (const scene::Measure measure : sweep.measures)
    text += "," + std::string(scene::nameOf(measure));
  text += kStatusColumn + "\n";
  for (const SweepRow& row : result.rows) {
    text += csvField(row.value);
    if (sweep.curves) text += "," + csvField(row.curve);
    for (const double value : row.measured) text += field(value);
    text += "," + row.end.text() + "\n";
  }
  return text;
}

}  // namespace rotatebook::study
