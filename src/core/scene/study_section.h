// [study], in and out.
#pragma once

#include <string>

#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

/// Reads the section; what it leaves out is as in defaultStudy() of the scene's model. The rest of
/// `scene` is read already, because what a study may vary depends on it. Throws InputError.
StudySettings readStudy(const ValueReader& section, const Scene& scene);

/// The section as TOML.
std::string studyText(const StudySettings& study);

}  // namespace rotatebook::scene
