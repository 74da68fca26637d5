// A rectangle of pixels.
#pragma once

#include <algorithm>

namespace rotatebook::image {

/// A rectangle of whole pixels; the origin is the picture's top left.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;  ///< [pixels]

  bool empty() const { return width <= 0 || height <= 0; }
  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

/// Returns what both have in common; it may be empty.
inline Area common(const Area& one, const Area& other) {
  const int x = std::max(one.x, other.x), y = std::max(one.y, other.y);
  return {x, y, std::min(one.right(), other.right()) - x,
          std::min(one.bottom(), other.bottom()) - y};
}

}  // namespace rotatebook::image
