// What became of a clip's motions, in words. Inside the room only.
#pragma once

#include <ostream>
#include <string>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::cli {

/// Says how far a motion of `model` was from the exact one, by the largest Sample::errorDeg:
/// "within 2e-9 degrees of the exact motion", or "up to 180 degrees from the exact motion; more
/// than 10 from 3.85 s on". Rounded up, so that it is a bound.
std::string distanceText(const physics::Trajectory& trajectory, physics::Model model);

/// Prints for each motion of `scene`, those of panels under their labels, its distanceText() and
/// what reportMotion() says of it; returns the worst of their statuses.
int reportMotions(const scene::Scene& scene, const timeline::ClipMotion& motion, std::ostream& out);

}  // namespace rotatebook::cli
