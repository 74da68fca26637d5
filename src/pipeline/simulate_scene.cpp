#include "pipeline/simulate_scene.h"

#include "base/error.h"

namespace rotatebook::pipeline {

ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop) {
  try {
    return {{physics::simulate(scene.motion(), scene.clip.frameCount(), stop)},
            scene.clip.frameRate};
  } catch (const InputError& error) {
    throw InputError((scene.folder / (scene.name + ".toml")).string() + ": " + error.what());
  }
}

}  // namespace rotatebook::pipeline
