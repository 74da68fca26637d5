// A clip's motions as JSON for the page's plots. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::page {

/// One of the motions that a clip shows.
struct Motion {
  scene::Panel panel;  ///< From scene::motionsOf().
  physics::Trajectory trajectory;
};

/// Returns JSON that is safe in a <script>: {"rate": [60, 1], "frames": 720, "interval": 0.0167,
/// "times": those of the frames, unless they are even, "checksum": that of the motion by the clip's
/// record, unless it is empty, "motions": [{"label", "springs": whether there are any, "kinetic",
/// "potential", "total", "tilt", "error"}]}. The last five are arrays with a number for each
/// sample: energies over the total at the start, angles in degrees.
std::string motionData(const std::vector<Motion>& motions, const scene::Scene& scene,
                       std::int64_t frames, const std::string& checksum);

}  // namespace rotatebook::page
