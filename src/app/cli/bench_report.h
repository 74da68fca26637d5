// What was measured of the machine's speed, in words and for programs. Inside the room only.
#pragma once

#include <ostream>

#include "diagnose/benchmark.h"
#include "diagnose/speed_limit.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// The frames a second, a table of stages, what limits and what would help.
void reportSpeed(const scene::Scene& scene, const diagnose::Speed& speed, std::ostream& out);

/// The same numbers as one JSON object: times a frame in ms, start_up_s in seconds.
void reportSpeedAsJson(const scene::Scene& scene, const diagnose::Speed& speed, std::ostream& out);

}  // namespace rotatebook::cli
