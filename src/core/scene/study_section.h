// Reads and prints [study]. Inside the room only.
#pragma once

#include <string>

#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

/// Reads the section into `scene`, the rest of which must be read already, because it decides what
/// a study may vary. What the section leaves out is as in defaultStudy() for the scene's model.
/// Throws InputError.
void readStudy(const ValueReader& section, Scene& scene);

/// Returns the section as TOML; empty for a scene without a study.
std::string studyText(const Scene& scene);

}  // namespace rotatebook::scene
