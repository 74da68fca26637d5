// Halves the size of pictures.
#pragma once

#include "image/image.h"

namespace rotatebook::image {

/// Writes to each pixel of `area` the mean in linear light of four pixels of `large`, weighted by
/// their alpha. Both are Rgba8, `large` twice as wide and high as the picture from whose top left
/// `picture` is.
void downsample(const Image& large, const Area& area, const Pixels& picture);

/// Returns `large` (Rgb8, or Rgba8, whose alpha is ignored) as Rgb8 with half as many pixels a
/// side, rounded down but at least 1. Each pixel is the mean in linear light of those it covers,
/// some of which count in part where a side is odd.
Image downsampledOpaque(const ImageView& large);
/// Returns `large` (Rgba8) likewise, as Rgba8: alpha is the mean of what is covered, too, and
/// weighs nothing.
Image downsampledApart(const ImageView& large);

}  // namespace rotatebook::image
