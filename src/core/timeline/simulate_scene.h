// Simulates the motions of a scene.
#pragma once

#include <atomic>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Returns the times of the clip's frames, each followed by those of `parts` - 1 >= 0 moments that
/// divide the frame evenly. [s]
std::vector<double> frameTimes(const scene::Scene& scene, int parts = 1);

/// Simulates all motions of the scene's clip, in the order of scene::motionsOf(). `stop` and
/// what is thrown are as in physics::simulate(); an InputError names the scene's file and
/// panel, too.
ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::timeline
