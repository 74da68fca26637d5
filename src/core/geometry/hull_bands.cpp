#include "geometry/hull_bands.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rotatebook::geometry {
namespace {

// Reach of rounding and of EdgeSamples' search for colours beyond the hull. [pixels]
constexpr int kMargin = 6;
constexpr int kBandRows = 32;  // Lower bands fit the hull more closely, but each has its cost.

/// Returns the first pixel and one past the last of those from `low` to `high`, with the margin,
/// within 0 to `size`.
std::pair<int, int> pixelSpan(double low, double high, int size) {
  const auto clamped = [size](double position) {
    return std::clamp(position, -1.0 * size, 2.0 * size);
  };
  const int first = static_cast<int>(std::floor(clamped(low))) - kMargin;
  const int end = static_cast<int>(std::ceil(clamped(high))) + kMargin;
  return {std::clamp(first, 0, size), std::clamp(end, 0, size)};
}

/// Returns the least and the greatest x of the hull between rows `top` and `bottom`, both of which
/// lie on segments between two of the points. The first is greater than the second if the hull
/// doesn't reach these rows.
std::pair<double, double> spanWithin(const PicturePoints& points, double top, double bottom) {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index j = 0; j < points.cols(); ++j) {
      const Eigen::Vector2d a = points.col(i), b = points.col(j);
      if (a.y() > b.y() || a.y() > bottom || b.y() < top) continue;
      for (const double row : {std::max(top, a.y()), std::min(bottom, b.y())}) {
        const double share = b.y() > a.y() ? (row - a.y()) / (b.y() - a.y()) : 0;
        const double x = a.x() + share * (b.x() - a.x());
        least = std::min(least, x);
        greatest = std::max(greatest, x);
      }
    }
  }
  return {least, greatest};
}

}  // namespace

PixelRect boundsOf(const PicturePoints& points, int width, int height) {
  const auto [left, right] = pixelSpan(points.row(0).minCoeff(), points.row(0).maxCoeff(), width);
  const auto [top, bottom] = pixelSpan(points.row(1).minCoeff(), points.row(1).maxCoeff(), height);
  return {left, top, right - left, bottom - top};
}

std::vector<PixelRect> hullBands(const PicturePoints& points, const PixelRect& bounds) {
  std::vector<PixelRect> bands;
  const int end = bounds.y + bounds.height, right = bounds.x + bounds.width;
  for (int y = bounds.y; y < end; y += kBandRows) {
    const int rows = std::min(kBandRows, end - y);
    const auto [least, greatest] = spanWithin(points, y - kMargin, y + rows + kMargin);
    if (least > greatest) continue;
    const auto [first, last] = pixelSpan(least, greatest, right);
    const int x = std::max(first, bounds.x);
    if (x < last) bands.push_back({x, y, last - x, rows});
  }
  return bands;
}

}  // namespace rotatebook::geometry
