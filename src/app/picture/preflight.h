// What of a scene proves wrong only when files and fonts are opened.
#pragma once

#include "scene/scene.h"

namespace rotatebook::picture {

/// Reads the scene's textures and sets its words and labels, only to find out before any work
/// whether that can be done. Throws InputError, as loadTextures() and Composition do.
void preflight(const scene::Scene& scene);

}  // namespace rotatebook::picture
