#include "picture/preflight.h"

#include "picture/composition.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {

TextureFiles preflight(const scene::Scene& scene) {
  TextureFiles files = readTextures(scene);
  requireText(scene);
  return files;
}

void requireText(const scene::Scene& scene) {
  // A clip of one frame has the text of the whole clip.
  scene::Scene first = scene;
  first.clip.duration = scene.clip.frameRate.period();
  const timeline::ClipMotion motion = timeline::simulateScene(first);
  const Composition composition(first, motion);
}

}  // namespace rotatebook::picture
