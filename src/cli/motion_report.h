// What became of a clip's motions, in words.
#pragma once

#include <ostream>

#include "pipeline/clip_motion.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// reportMotion() of each motion of `scene`, those of panels under their labels; the worst of
/// their statuses.
int reportMotions(const scene::Scene& scene, const pipeline::ClipMotion& motion, std::ostream& out);

}  // namespace rotatebook::cli
