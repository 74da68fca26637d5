// The motion of a scene.
#pragma once

#include <atomic>
#include <cstdint>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// The first `frames` >= 1 samples of the scene's motion; `stop` and what is thrown as
/// physics::simulate() has them, with the scene's file named.
physics::Trajectory simulateScene(const scene::Scene& scene, std::int64_t frames,
                                  const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::pipeline
