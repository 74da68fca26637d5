// The commonest silent failure of a driver: a frame in which nothing was drawn.
#pragma once

#include <vector>

#include "image/image.h"
#include "render/hull_bands.h"

namespace rotatebook::render {

/// Whether all pixels of `bands` are the same in `picture` (Rgba8). Bands that together are so
/// small that they may rightly be of one colour never are.
bool isBlank(const image::Image& picture, const std::vector<PixelRect>& bands);

}  // namespace rotatebook::render
