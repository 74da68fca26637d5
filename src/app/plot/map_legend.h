// The legend of a map's colours. Inside the room only.
#pragma once

#include "plot/map_colours.h"
#include "plot/map_layout.h"

namespace rotatebook::plot {

/// Draws the name of what is shown, the colours of its values and those of runs without a number.
void drawLegend(const scene::MapSettings& map, const study::MapFacts& facts,
                const MapColouring& colouring, const MapLayout& layout, Drawing& drawing);

}  // namespace rotatebook::plot
