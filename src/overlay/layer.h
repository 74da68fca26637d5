// A piece of picture to lay over another.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

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

/// Lays `layer` over `picture`; what lies outside is left out. Alpha of the picture grows to what
/// both cover together.
void blend(const Layer& layer, image::Image& picture);

}  // namespace rotatebook::overlay
