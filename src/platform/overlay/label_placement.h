// Places labels beside points of a picture. Inside the room only.
#pragma once

#include <span>
#include <vector>

#include "overlay/canvas.h"

namespace rotatebook::overlay {

/// Writes `label` with its middle `distance` from `tip` in `direction`, or else near there, such
/// that it is within `area` and meets nothing that is `taken`, to which its box is added. Leaves
/// the label out if there is no room. [pixels]
void writeBeside(Canvas& canvas, const Layer& label, const Point& tip, const Point& direction,
                 double distance, const Box& area, std::vector<Box>& taken);

/// Moves labels of this height up where they would meet the one below, or reach below `bottom`;
/// takes and leaves their middles, the lowest label's first. [pixels]
void stackUpward(std::span<double> middles, double height, double bottom);

}  // namespace rotatebook::overlay
