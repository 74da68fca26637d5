// The motion of a scene.
#pragma once

#include <atomic>

#include "pipeline/clip_motion.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// The whole motion of the scene's clip; `stop` and what is thrown as physics::simulate() has them,
/// with the scene's file named.
ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::pipeline
