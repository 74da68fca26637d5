// The motions of a scene.
#pragma once

#include <atomic>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// All motions of the scene's clip, as scene::motionsOf() has them; `stop` and what is thrown as
/// physics::simulate() has them, with the scene's file and panel named.
ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::timeline
