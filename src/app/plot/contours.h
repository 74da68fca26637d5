// Contour lines of a map. Inside the room only.
#pragma once

#include <vector>

#include "overlay/box.h"

namespace rotatebook::plot {

/// Returns the lines, point pair by point pair, along which the values reach `level`; coordinates
/// are numbers of runs from the left bottom, those of a run's middle being whole. No line crosses
/// runs without a number. Uses marching squares.
std::vector<overlay::Point> contourOf(const std::vector<double>& values, int width, int height,
                                      double level);

}  // namespace rotatebook::plot
