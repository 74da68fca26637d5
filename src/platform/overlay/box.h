// Upright rectangles on a picture. Inside the room only.
#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace rotatebook::overlay {

/// A place on a picture, from its top left. [pixels]
using Point = Eigen::Vector2d;

/// A rectangle. [pixels]
struct Box {
  double x = 0, y = 0;           ///< Its top left.
  double width = 0, height = 0;  ///< >= 0; nothing meets a box of no size.

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
  /// Whether the two share more than an edge.
  bool meets(const Box& other) const {
    return !empty() && !other.empty() && x < other.right() && other.x < right() &&
           y < other.bottom() && other.y < bottom();
  }
  bool holds(const Box& other) const {
    return x <= other.x && y <= other.y && other.right() <= right() && other.bottom() <= bottom();
  }
  /// Larger by `margin` on each side.
  Box grown(double margin) const {
    return {x - margin, y - margin, width + 2 * margin, height + 2 * margin};
  }
  /// The smallest box that holds both; an empty one counts for nothing.
  Box united(const Box& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    const double left = std::min(x, other.x), top = std::min(y, other.y);
    return {left, top, std::max(right(), other.right()) - left,
            std::max(bottom(), other.bottom()) - top};
  }
};

}  // namespace rotatebook::overlay
