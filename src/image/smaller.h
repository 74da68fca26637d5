// Pictures of half the size.
#pragma once

#include "image/image.h"

namespace rotatebook::image {

/// Writes to each pixel of `picture` the mean, of light, of four pixels of `large`, which count by
/// their alpha. Both are Rgba8, `large` twice as wide and high.
void halve(const Image& large, Image& picture);

}  // namespace rotatebook::image
