// A map as a designed picture: title, legend, axes, marks and caption.
#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "study/map_result.h"

namespace rotatebook::picture {

/// Throws InputError if the font that ships with the program lacks a letter of the map's texts:
/// before the runs rather than after them.
void requireMapText(const scene::Scene& scene);

/// Draws the map of `scene`, which has one, on dark ground: a pixel, or a square of pixels, for
/// each run; of a very large map only some of the runs. Panels are side by side. Throws like
/// requireMapText().
image::Image drawMapSheet(const study::MapResult& result, const scene::Scene& scene);

/// Returns the width of that picture, which the ticks' labels decide, too. Of maps that differ in
/// the ranges of their axes alone, all else is at the same distance from the right.
int mapSheetWidth(const scene::Scene& scene);
/// Returns such a picture at the right of one that is so wide, and of an even height. [pixels]
image::Image onGround(const image::Image& sheet, int width);

}  // namespace rotatebook::picture
