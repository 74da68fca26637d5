// Reports on a clip's motions.
#pragma once

#include <ostream>
#include <string>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::report {

/// Returns how far a motion of `model` was from the exact one, by the largest Sample::errorDeg:
/// "within 2e-9 degrees of the exact motion", or "up to 180 degrees from the exact motion; more
/// than 10 from 3.85 s on". Rounded up, so that it is a bound.
std::string distanceText(const physics::Trajectory& trajectory, physics::Model model);

/// Returns the change of the total energy: "energy kept to 3e-13" while it is below a thousandth,
/// else "energy 0.7217 to 1 of its start".
std::string energyText(const physics::Trajectory& trajectory);

/// Prints a line "note: NAME: ..." to `out` for each of timeline::notesOn(scene).
void reportNotes(const scene::Scene& scene, std::ostream& out);

/// Prints the half-turns, the energyText(), the distanceText() and the reportMotion() of each
/// motion of `scene`, a panel's under its label, and the notes on its regime. Returns
/// whether all expectations are met.
bool reportMotions(const scene::Scene& scene, const timeline::ClipMotion& motion,
                   std::ostream& out);

}  // namespace rotatebook::report
