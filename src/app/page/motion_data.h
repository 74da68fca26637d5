// A clip's motions as the page's plots read them. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// One of the motions that a clip shows.
struct Motion {
  scene::Panel panel;  ///< As scene::motionsOf() has it.
  physics::Trajectory trajectory;
};

/// JSON that may stand in a <script>: {"rate": [60, 1], "frames": 720, "interval": 0.0167,
/// "motions":
/// [{"label", "springs": whether there are any, "kinetic", "potential", "total", "tilt",
/// "error"}]}, the last five a number a sample: energies over the total at the start, angles in
/// degrees.
std::string motionData(const std::vector<Motion>& motions, const scene::ClipSettings& clip,
                       std::int64_t frames);

}  // namespace rotatebook::page
