// The motion of a scene.
#pragma once

#include <cstdint>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// The first `frames` >= 1 samples of the scene's motion. Throws InputError as physics::simulate()
/// does, with the scene's file named.
physics::Trajectory simulateScene(const scene::Scene& scene, std::int64_t frames);

}  // namespace rotatebook::pipeline
