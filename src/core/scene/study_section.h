// [study], in and out.
#pragma once

#include <string>

#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

/// Reads the section into `scene`, of which the rest is read already, because what a study may vary
/// depends on it. What the section leaves out is as in defaultStudy() of the scene's model. Throws
/// InputError.
void readStudy(const ValueReader& section, Scene& scene);

/// The section as TOML, empty for a scene without a study.
std::string studyText(const Scene& scene);

}  // namespace rotatebook::scene
