// Studies as CSV tables.
#pragma once

#include <string>
#include <string_view>

#include "study/study.h"
#include "study/sweep.h"

namespace rotatebook::study {

// Numbers read back to the same bits; the field of a number that a run doesn't have is empty.

/// Returns a text as a field of a CSV, in quotes if it needs them. (RFC 4180)
std::string csvField(const std::string& text);

/// Returns a header row and one row a run: integrator, h_s, steps, error_deg, final_error_deg,
/// energy_drift, L_drift, half_turns, ns_per_step, status.
std::string precisionCsv(const PrecisionStudy& study);

/// Returns a header row and one row an integrator: integrator, order, runs, shortest_h_s,
/// longest_h_s.
std::string ordersCsv(const PrecisionStudy& study);

/// Returns a header row and one row a tilt: tilt_rad, flips, interval_s, law_s, ratio, status.
std::string tiltCsv(const TiltStudy& study);

/// Returns a header row and one row a run: the key, the key of the curves if there is one, each
/// measured quantity, status. A motion that doesn't diverge has "inf" for diverges_at.
std::string sweepCsv(const SweepStudy& result, const scene::Sweep& sweep);

/// Returns whether a table of runs with this header row is a study's.
bool isStudyHeader(std::string_view row);

}  // namespace rotatebook::study
