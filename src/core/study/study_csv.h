// Studies as tables.
#pragma once

#include <string>

#include "study/study.h"

namespace rotatebook::study {

// Numbers read back to the same bits; those that a run doesn't have are empty.

/// A row a run under a header row: integrator, h_s, steps, error_deg, final_error_deg,
/// energy_drift, L_drift, half_turns, ns_per_step, status.
std::string precisionCsv(const PrecisionStudy& study);

/// A row an integrator: integrator, order, runs, shortest_h_s, longest_h_s.
std::string ordersCsv(const PrecisionStudy& study);

/// A row a tilt: tilt_rad, flips, interval_s, law_s, ratio, status.
std::string tiltCsv(const TiltStudy& study);

}  // namespace rotatebook::study
