// A table of how a clip's motions were simulated. Inside the room only.
#pragma once

#include <vector>

#include "page/html.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// Returns a row for each setting, a column for each motion; the last row is the clip's.
Html settingsTable(const std::vector<scene::Panel>& motions, const scene::ClipSettings& clip,
                   const Language& say = {});

}  // namespace rotatebook::page
