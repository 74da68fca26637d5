// What a page reads of a scene and of the program's words. Inside the room only.
#pragma once

#include <string>

#include "scene/scene.h"

namespace rotatebook::bridge {

/// Returns the JSON of rb_words().
std::string wordsJson();
/// Returns the JSON of rb_read().
std::string sceneJson(const scene::Scene& scene);

}  // namespace rotatebook::bridge
