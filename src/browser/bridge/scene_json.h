// A scene and the program's words as JSON, for a page. Inside the room only.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace rotatebook::bridge {

/// Returns the JSON of rb_words().
std::string wordsJson();
/// Returns the JSON of rb_read().
std::string sceneJson(const scene::Scene& scene);
/// Returns the JSON of rb_recording(). Throws InputError, beginning with `name`, for what is none.
std::string recordingJson(std::string_view bytes, const std::string& name);

}  // namespace rotatebook::bridge
