// Every key of a scene file in words, as docs/scene.md has them.
#pragma once

#include <vector>

#include "scene/keys/key_row.h"

namespace rotatebook::scene {

/// All keys, section by section, each section's in the order of messages.
std::vector<KeyRow> allKeys();

}  // namespace rotatebook::scene
