// Images with alpha that are laid over a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace rotatebook::image {

/// An image with alpha at a position on a picture.
struct Layer {
  int x = 0;       ///< Of its top left pixel on the picture; may be outside. [pixels]
  int y = 0;       ///< [pixels]
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  /// Row by row from the top: blue, green, red, alpha; sRGB values, premultiplied by alpha.
  std::vector<std::uint8_t> pixels;
};

/// A layer, or a part of one, that somebody else owns.
struct LayerView {
  int x = 0, y = 0, width = 0, height = 0;  ///< Like Layer's. [pixels]
  const std::uint8_t* pixels = nullptr;     ///< Starts at the top left pixel.
  std::ptrdiff_t stride = 0;                ///< From a row to the one below. [bytes]
};

/// Returns a view of the whole of `layer`.
LayerView viewOf(const Layer& layer);

/// Blends `layer` over `picture`, cropped to it. A picture's alpha, if it has one, is straight, and
/// grows to the opacity of both together.
void blend(const LayerView& layer, Image& picture);
inline void blend(const Layer& layer, Image& picture) {
  blend(viewOf(layer), picture);
}
/// Blends `layer` likewise, cropped to an area of the picture.
void blendWithin(const Area& area, const LayerView& layer, Image& picture);
/// Blends `layer` likewise, over those tiles alone that were touched since Image::beginOn().
void blendOverTouched(const Area& area, const LayerView& layer, Image& picture);

}  // namespace rotatebook::image
