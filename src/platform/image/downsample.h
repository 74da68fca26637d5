// Pictures of half the size.
#pragma once

#include "image/image.h"

namespace rotatebook::image {

/// Writes to each pixel of `picture` the mean, of light, of four pixels of `large`, which count by
/// their alpha. Both are Rgba8, `large` twice as wide and high.
void downsample(const Image& large, Image& picture);

/// The picture (Rgb8, or Rgba8, whose alpha is left out) with half as many pixels a side, rounded
/// down but at least 1: each is the mean, of light, of those it covers, of which some count in part
/// where a side is odd. Rgb8.
Image downsampledOpaque(const ImageView& large);

}  // namespace rotatebook::image
