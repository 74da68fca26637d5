// A scene and the program's words as JSON, for a page. Inside the room only.
#pragma once

#include <string>

#include "base/json.h"
#include "scene/scene.h"

namespace rotatebook::bridge {

/// Returns the JSON of rb_words().
Json wordsJson();
/// Returns the JSON of rb_read().
Json sceneJson(const scene::Scene& scene);

}  // namespace rotatebook::bridge
