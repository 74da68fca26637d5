// How a clip's motions were simulated, as a table. Inside the room only.
#pragma once

#include <vector>

#include "page/html.h"
#include "page/motion_data.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// A row a setting, a column a motion; the last rows are the clip's.
Html settingsTable(const std::vector<Motion>& motions, const scene::ClipSettings& clip);

}  // namespace rotatebook::page
