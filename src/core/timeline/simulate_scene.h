// The motions of a scene.
#pragma once

#include <atomic>

#include "physics/layout.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// All motions of the scene's clip, as scene::motionsOf() has them; `stop` and what is thrown as
/// physics::simulate() has them, with the scene's file and panel named. `caller` as there.
ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop = nullptr,
                         const physics::Layout& caller = physics::layoutHere());

}  // namespace rotatebook::timeline
