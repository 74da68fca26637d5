// Checks what only shows when a scene's files and fonts are opened.
#pragma once

#include <string>
#include <vector>

#include "picture/looks.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Returns timeline::notesOn() a scene, and sentences on overlays for which its pictures have no
/// room, and on cues that take more than two lines. Throws InputError like Composition.
std::vector<std::string> notesOn(const scene::Scene& scene);

/// The results of a check before any work.
struct Preflight {
  TextureFiles textures{};           ///< For whoever draws the scene.
  std::vector<std::string> notes{};  ///< notesOn() the scene.
};

/// Verifies, before any work, that the scene's textures can be read and its text can be set.
/// Throws InputError like readTextures() and Composition.
Preflight preflight(const scene::Scene& scene);

}  // namespace rotatebook::picture
