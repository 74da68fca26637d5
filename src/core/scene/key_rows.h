// The documentation of every key of a scene file, as the tables of docs/scene.md have it. Inside
// the room only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/key_row.h"

namespace rotatebook::scene {

/// Returns all keys, section by section, those of each section in the order of messages.
std::vector<KeyRow> allKeys();

/// Returns where a key of that name belongs: "under [body] or [clip]"; empty if nowhere.
std::string sectionsOf(std::string_view key);

}  // namespace rotatebook::scene
