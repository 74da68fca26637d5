// Checks what only shows when a scene's files and fonts are opened.
#pragma once

#include <string>
#include <vector>

#include "picture/looks.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Verifies, before any work, that the scene's textures can be read and its text can be set.
/// Returns the texture files, for whoever draws the scene. Throws InputError like readTextures()
/// and Composition.
TextureFiles preflight(const scene::Scene& scene);
/// Verifies that the scene's text can be set. Throws InputError like Composition.
void requireText(const scene::Scene& scene);

/// Returns timeline::notesOn() a scene, and sentences on overlays for which its pictures have no
/// room, and on cues that take more than two lines. Throws InputError like Composition.
std::vector<std::string> notesOn(const scene::Scene& scene);

}  // namespace rotatebook::picture
