#include "geometry/depth_map.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace rotatebook::geometry {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFar = -2;  // Below the ball.
// The ball's radius in the map: a shadow is looked up a pixel farther out.
constexpr double kRadius = DepthMap::kPixels / 2.0 - 4;

/// Returns the first pixel whose middle is at `place` or after it, 0 to `kPixels`.
int pixelFrom(double place) {
  return static_cast<int>(std::clamp(place + 0.5, 0.0, double{DepthMap::kPixels}));
}

/// Returns where the line from a to b crosses a row's middle.
double crossing(const Vector3d& a, const Vector3d& b, double row) {
  return a.x() + (b.x() - a.x()) * ((row - a.y()) / (b.y() - a.y()));
}

}  // namespace

DepthMap::DepthMap(const Vector3d& direction)
    : direction_(direction), heights_(std::size_t{kPixels} * kPixels, kFar) {
  int axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  across_ = Vector3d::Unit(axis).cross(direction).normalized();
  up_ = direction.cross(across_);
}

Vector3d DepthMap::placeOf(const Vector3d& point) const {
  return {kPixels / 2.0 + kRadius * across_.dot(point), kPixels / 2.0 + kRadius * up_.dot(point),
          direction_.dot(point)};
}

void DepthMap::draw(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  if (!(normal.z() > 0)) return;
  const auto [lowest, highest] = std::minmax({a.z(), b.z(), c.z()});
  const Plane plane{a.head<2>(), -normal.head<2>() / normal.z(), a.z(), lowest, highest};
  const auto [bottom, top] = std::minmax({a.y(), b.y(), c.y()});
  for (int row = pixelFrom(bottom); row < pixelFrom(top); ++row) drawRow(row, {a, b, c}, plane);
}

void DepthMap::drawRow(int row, const std::array<Vector3d, 3>& corners, const Plane& plane) {
  const double middle = row + 0.5;
  double left = kPixels, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &from = corners[i], &to = corners[(i + 1) % 3];
    if ((from.y() <= middle) == (to.y() <= middle)) continue;
    const double x = crossing(from, to, middle);
    left = std::min(left, x);
    right = std::max(right, x);
  }
  for (int column = pixelFrom(left); column < pixelFrom(right); ++column) {
    const Vector2d place(column + 0.5, middle);
    const double height = std::clamp(plane.height + plane.slopes.dot(place - plane.from),
                                     plane.lowest, plane.highest);
    float& seen =
        heights_[static_cast<std::size_t>(row) * kPixels + static_cast<std::size_t>(column)];
    seen = std::max(seen, static_cast<float>(height));
  }
}

double DepthMap::seenShare(const Vector3d& place) const {
  const double x = place.x() - 0.5, y = place.y() - 0.5;
  const auto column = static_cast<std::size_t>(std::clamp(x, 0.0, kPixels - 2.0));
  const auto row = static_cast<std::size_t>(std::clamp(y, 0.0, kPixels - 2.0));
  const double right = x - static_cast<double>(column), upper = y - static_cast<double>(row);
  const auto seen = [&](std::size_t i, std::size_t j) {
    return heights_[(row + j) * kPixels + column + i] <= place.z() ? 1.0 : 0.0;
  };
  const double low = seen(0, 0) + right * (seen(1, 0) - seen(0, 0));
  const double high = seen(0, 1) + right * (seen(1, 1) - seen(0, 1));
  return low + upper * (high - low);
}

}  // namespace rotatebook::geometry
