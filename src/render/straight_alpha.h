// From light times coverage, as it is drawn, to colours beside their coverage, as files have them.
#pragma once

#include "image/image.h"
#include "render/camera.h"

namespace rotatebook::render {

/// Divides the light of each pixel of `area` by its alpha; `picture` (Rgba8) holds sRGB of their
/// product. Pixels that nothing covers become black.
void makeAlphaStraight(image::Image& picture, const PixelRect& area);

}  // namespace rotatebook::render
