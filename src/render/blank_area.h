// The commonest silent failure of a driver: a frame in which nothing was drawn.
#pragma once

#include "image/image.h"
#include "render/camera.h"

namespace rotatebook::render {

/// Whether all pixels of `area` are the same in `picture` (Rgba8). Areas so small that they may
/// rightly be of one colour never are.
bool isBlank(const image::Image& picture, const PixelRect& area);

}  // namespace rotatebook::render
