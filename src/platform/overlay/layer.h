// Pieces of picture to lay over another. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"

namespace rotatebook::overlay {

/// Pixels that cover what is below them by their opacity.
struct Layer {
  int x = 0;       ///< Where its top left pixel lies on the picture; may be outside. [pixels]
  int y = 0;       ///< [pixels]
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  /// Row by row from the top, blue, green, red, alpha; colours are sRGB times alpha.
  std::vector<std::uint8_t> pixels;
};

/// A layer that somebody else owns, or a part of one.
struct LayerView {
  int x = 0, y = 0, width = 0, height = 0;  ///< As Layer has them. [pixels]
  const std::uint8_t* pixels = nullptr;     ///< Of its top left pixel.
  std::ptrdiff_t stride = 0;                ///< From a row to the one below. [bytes]
};

/// The whole of `layer`.
LayerView viewOf(const Layer& layer);

/// A layer that is the same in each frame, and where on the picture it has words.
struct CachedLayer {
  Layer layer;
  std::vector<Box> texts;
};

/// Lays `layer` over `picture`; what lies outside is left out. Where the picture has alpha it is
/// straight, and grows to what both cover together.
void blend(const LayerView& layer, image::Image& picture);
inline void blend(const Layer& layer, image::Image& picture) {
  blend(viewOf(layer), picture);
}

}  // namespace rotatebook::overlay
