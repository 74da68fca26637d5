// Axis-aligned rectangles on a picture.
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::overlay {

/// A position on a picture, or a distance on it, from the top left, y down. [pixels]
using Point = Eigen::Vector2d;

/// A rectangle. [pixels]
struct Box {
  double x = 0, y = 0;           ///< Its top left corner.
  double width = 0, height = 0;  ///< >= 0; an empty box meets nothing.

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool empty() const { return width <= 0 || height <= 0; }
  /// Returns whether the two boxes share more than an edge.
  bool meets(const Box& other) const {
    return !empty() && !other.empty() && x < other.right() && other.x < right() &&
           y < other.bottom() && other.y < bottom();
  }
  bool holds(const Box& other) const {
    return x <= other.x && y <= other.y && other.right() <= right() && other.bottom() <= bottom();
  }
  /// Returns this box, larger by `margin` on each side.
  Box grown(double margin) const {
    return {x - margin, y - margin, width + 2 * margin, height + 2 * margin};
  }
  Box moved(const Point& by) const { return {x + by.x(), y + by.y(), width, height}; }
  /// Returns the smallest box that holds both; an empty one counts for nothing.
  Box united(const Box& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    const double left = std::min(x, other.x), top = std::min(y, other.y);
    return {left, top, std::max(right(), other.right()) - left,
            std::max(bottom(), other.bottom()) - top};
  }
};

/// Returns whether `text` lies within `area`, and at least a pixel from all that is `taken`.
inline bool isFree(const Box& text, const Box& area, const std::vector<Box>& taken) {
  return area.holds(text) &&
         std::ranges::none_of(taken, [&](const Box& other) { return other.grown(1).meets(text); });
}

}  // namespace rotatebook::overlay
