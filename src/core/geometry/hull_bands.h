// Bounds the pixels that a projected body can touch.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace rotatebook::geometry {

/// A rectangle of whole pixels; the origin is the picture's top left.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Points on a picture, x to the right and y down. [pixels]
using PicturePoints = Eigen::Matrix<double, 2, 8>;

/// Returns the smallest rectangle that holds the points and a margin for antialiasing, within a
/// picture of this size; empty if all points lie outside it.
PixelRect boundsOf(const PicturePoints& points, int width, int height);

/// Returns rectangles, one below the other, that together hold the points' convex hull and a
/// margin, and little else. They lie within `bounds`, from boundsOf().
std::vector<PixelRect> hullBands(const PicturePoints& points, const PixelRect& bounds);

}  // namespace rotatebook::geometry
