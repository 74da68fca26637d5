// Reports on a clip's motions. Inside the room only.
#pragma once

#include <ostream>
#include <string>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::cli {

/// Returns how far a motion of `model` was from the exact one, by the largest Sample::errorDeg:
/// "within 2e-9 degrees of the exact motion", or "up to 180 degrees from the exact motion; more
/// than 10 from 3.85 s on". Rounded up, so that it is a bound.
std::string distanceText(const physics::Trajectory& trajectory, physics::Model model);

/// Prints the distanceText() and the reportMotion() of each motion of `scene`, a panel's under its
/// label; returns the worst of their statuses.
int reportMotions(const scene::Scene& scene, const timeline::ClipMotion& motion, std::ostream& out);

}  // namespace rotatebook::cli
