#include "pipeline/preflight.h"

#include "pipeline/composition.h"
#include "pipeline/simulate_scene.h"
#include "pipeline/textures.h"

namespace rotatebook::pipeline {

void preflight(const scene::Scene& scene) {
  requireTextures(scene);
  // Of one frame, words and labels are those of the whole clip.
  scene::Scene first = scene;
  first.clip.duration = scene.clip.frameRate.period();
  const ClipMotion motion = simulateScene(first);
  const Composition composition(first, motion);
}

}  // namespace rotatebook::pipeline
