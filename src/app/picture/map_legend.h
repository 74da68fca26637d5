// The legend of a map's colours. Inside the room only.
#pragma once

#include "image/image.h"
#include "overlay/canvas.h"
#include "picture/map_colours.h"
#include "picture/map_layout.h"

namespace rotatebook::picture {

/// Draws the name of what is shown, the colours of its values and those of runs without a number.
void drawLegend(const scene::Scene& scene, const study::MapFacts& facts,
                const MapColouring& colouring, const MapLayout& layout,
                const overlay::Typesetter& type, overlay::Canvas& canvas, image::Image& sheet);

}  // namespace rotatebook::picture
