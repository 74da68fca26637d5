// Reports of measureSpeed(), as text and as JSON.
#pragma once

#include <ostream>

#include "diagnose/benchmark.h"
#include "diagnose/speed_limit.h"
#include "scene/scene.h"

namespace rotatebook::report {

/// Prints the frames a second, a table of stages, what limits the speed and what would help.
void reportSpeed(const scene::Scene& scene, const diagnose::Speed& speed, std::ostream& out);

/// Prints the same numbers as one JSON object. Times are in ms a frame, start_up_s in seconds.
void reportSpeedAsJson(const scene::Scene& scene, const diagnose::Speed& speed, std::ostream& out);

}  // namespace rotatebook::report
