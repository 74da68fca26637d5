// A scene's text as one would write it. Inside the room only.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rotatebook::page {

/// Returns the scene's text without comments and what is so by default. Reading it back gives an
/// equal scene.
std::string shortText(const scene::Scene& scene);

}  // namespace rotatebook::page
