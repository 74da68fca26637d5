// Ticks of a map's axes. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "scene/scale.h"

namespace rotatebook::plot {

struct Tick {
  double value;
  std::string label;  ///< Empty of a small tick.
};

/// Returns round numbers within the range, about `wanted` of them with labels; on a logarithmic
/// scale powers of ten, with small ticks between them. Round numbers of degrees are parts of a
/// right angle.
std::vector<Tick> ticksOf(double from, double to, scene::Scale scale, int wanted,
                          bool isInDegrees = false);

/// Returns a number for people: "0.01", "10⁻⁵", "−3".
std::string tickText(double value);

}  // namespace rotatebook::plot
