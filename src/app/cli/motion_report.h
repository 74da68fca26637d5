// Reports on a clip's motions, as text and as JSON. Inside the room only.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/expectation.h"
#include "scene/scene.h"
#include "scene/study_settings.h"
#include "timeline/motion_summary.h"

namespace rotatebook::cli {

/// Returns how far a motion was from the exact one: "within 2e-9 degrees of the exact motion", or
/// "up to 180 degrees from the exact motion; more than 10 from 3.85 s on". Rounded up, so that it
/// is a bound.
std::string distanceText(const timeline::MotionSummary& summary);

/// Returns the change of the total energy: "energy kept to 3e-13" while it is below a thousandth,
/// else "energy 0.7217 to 1 of its start".
std::string energyText(const timeline::MotionSummary& summary);

/// Prints a line "note: NAME: ..." to `out` for each of timeline::notesOn(scene).
void reportNotes(const scene::Scene& scene, std::ostream& out);
/// Prints these `notes` on the scene likewise.
void reportNotes(const scene::Scene& scene, std::vector<std::string> notes, std::ostream& out);

/// Prints a line "note: NAME: ..." likewise, or "note: NAME, LABEL: ..." of a panel, for each note
/// on `motions`, those of `scene`.
void reportNotes(const scene::Scene& scene, const std::vector<timeline::MotionSummary>& motions,
                 std::ostream& out);

/// Prints the half-turns, the energyText(), the distanceText(), divergence and expectations of each
/// of `motions`, a panel's under its label.
void reportMotions(const std::vector<timeline::MotionSummary>& motions, std::ostream& out);

/// Returns the same as a JSON array. Unknown values are null.
Json motionsJson(const std::vector<timeline::MotionSummary>& motions);

/// A table that was written.
struct WrittenTable {
  std::filesystem::path path;
  std::size_t rows = 0;  ///< Without its header.
};

/// Prints the JSON object of a simulation of `scene`, which left `tables`.
void reportSimulationAsJson(const scene::Scene& scene, const std::vector<WrittenTable>& tables,
                            const std::vector<timeline::MotionSummary>& motions, std::ostream& out);

/// Returns one line: "met      tilt_deg: expected at most 1.5; measured 0.02 to 1.31".
std::string reportLine(const scene::ExpectationResult& result);

/// Returns such a line for one number: "met      order of rk4: expected at least 3.9;
/// measured 4.01". A NaN is printed as "nothing".
std::string reportLine(const std::string& subject, const scene::Bounds& bounds, double measured);

/// Prints a motion's divergence, if any, and a line for each of its expectations to `out`.
void reportExpectations(const timeline::MotionSummary& summary, std::ostream& out);

}  // namespace rotatebook::cli
