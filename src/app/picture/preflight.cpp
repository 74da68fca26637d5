#include "picture/preflight.h"

#include "picture/composition.h"
#include "picture/textures.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {

void preflight(const scene::Scene& scene) {
  requireTextures(scene);
  // A clip of one frame has the text of the whole clip.
  scene::Scene first = scene;
  first.clip.duration = scene.clip.frameRate.period();
  const timeline::ClipMotion motion = timeline::simulateScene(first);
  const Composition composition(first, motion);
}

}  // namespace rotatebook::picture
