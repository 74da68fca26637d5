#include "pipeline/preflight.h"

#include "pipeline/composition.h"
#include "pipeline/textures.h"

namespace rotatebook::pipeline {

void preflight(const scene::Scene& scene) {
  requireTextures(scene);
  wordsOf(scene);
}

}  // namespace rotatebook::pipeline
