// Notes on scenes that are valid, but perhaps not meant.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Returns a sentence for each setting that is likely a slip: a tilt that looks like degrees, a
/// body that looks like centimetres, a spin or flips too fast for the frame rate, and a spin
/// exactly about the median axis, which never tumbles. One of a panel begins with the panel's
/// label.
std::vector<std::string> notesOn(const scene::Scene& scene);

/// Returns a sentence for each motion of `scene` whose regime changes, which no free body's does,
/// with the time at which it first does.
std::vector<std::string> notesOn(const scene::Scene& scene, const ClipMotion& motion);

}  // namespace rotatebook::timeline
