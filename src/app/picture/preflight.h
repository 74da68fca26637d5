// Checks what only shows when a scene's files and fonts are opened.
#pragma once

#include "scene/scene.h"

namespace rotatebook::picture {

/// Verifies, before any work, that the scene's textures can be read and its text can be set. Throws
/// InputError like loadTextures() and Composition.
void preflight(const scene::Scene& scene);

}  // namespace rotatebook::picture
