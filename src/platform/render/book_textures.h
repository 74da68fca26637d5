// The pictures on the book's cover.
#pragma once

#include "base/rgb.h"
#include "image/image.h"

namespace rotatebook::render {

/// The pictures on the book's cover, each upright to a viewer of its side.
struct BookTextures {
  image::Image front, spine, back;
};

/// Return the parts of the built-in cover.
image::Image builtinFront();
image::Image builtinSpine();
image::Image builtinBack();
/// Returns the edges of leaves, which repeat across and down.
image::Image builtinPaper();
/// Returns the picture of a side of plain cloth.
image::Image plainCloth(const Rgb& colour);

/// Returns a side's picture as Rgba8, whose alpha is the share that isn't gold: gold has much less
/// blue than red, and much green. A single pixel is plain cloth, in which no gold is stamped,
/// whatever its colour.
image::Image withGold(const image::Image& side);

}  // namespace rotatebook::render
