// The report of the command bench, as text and as JSON. Inside the room only.
#pragma once

#include <ostream>

#include "pipeline/benchmark.h"
#include "pipeline/speed_limit.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// Prints the frames a second, a table of stages, what limits the speed and what would help.
void reportSpeed(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out);

/// Prints the same numbers as one JSON object. Times are in ms a frame, start_up_s in seconds.
void reportSpeedAsJson(const scene::Scene& scene, const pipeline::Speed& speed, std::ostream& out);

}  // namespace rotatebook::cli
