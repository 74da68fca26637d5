#include "pipeline/simulate_scene.h"

#include "base/error.h"

namespace rotatebook::pipeline {

physics::Trajectory simulateScene(const scene::Scene& scene, std::int64_t frames,
                                  const std::atomic<bool>* stop) {
  try {
    return physics::simulate(scene.motion(), frames, stop);
  } catch (const InputError& error) {
    throw InputError((scene.folder / (scene.name + ".toml")).string() + ": " + error.what());
  }
}

}  // namespace rotatebook::pipeline
