// Contour lines of a map.
#include <array>
#include <cmath>
#include <cstddef>

#include "plot/plot.h"

namespace rotatebook::plot {
namespace {

/// Returns the points at which the level is reached on the edges of the square above and right of
/// run (x, y): none, two or four.
std::vector<Point> crossings(const std::vector<double>& values, int width, int x, int y,
                             double level) {
  constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<double, 4> corner{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto column = static_cast<std::size_t>(x + kCorners[i][0]);
    const auto row = static_cast<std::size_t>(y + kCorners[i][1]);
    corner[i] = values[row * static_cast<std::size_t>(width) + column] - level;
    if (!std::isfinite(corner[i])) return {};
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if ((corner[i] < 0) == (corner[next] < 0)) continue;
    const double share = corner[i] / (corner[i] - corner[next]);
    points.emplace_back(x + kCorners[i][0] + share * (kCorners[next][0] - kCorners[i][0]),
                        y + kCorners[i][1] + share * (kCorners[next][1] - kCorners[i][1]));
  }
  return points;
}

}  // namespace

std::vector<Point> contourOf(const std::vector<double>& values, int width, int height,
                             double level) {
  std::vector<Point> pairs;
  for (int y = 0; y + 1 < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      for (const Point& point : crossings(values, width, x, y, level)) pairs.push_back(point);
    }
  }
  return pairs;
}

}  // namespace rotatebook::plot
