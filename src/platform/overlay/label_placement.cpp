#include "overlay/label_placement.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace rotatebook::overlay {
namespace {

// Rotations from the preferred direction that are tried, the smallest first. [rad]
constexpr std::array<double, 7> kTurns{0, 0.7, -0.7, 1.4, -1.4, 2.1, -2.1};
constexpr std::array<double, 3> kDistances{1, 1.5, 2.1};

}  // namespace

void writeBeside(Canvas& canvas, const Layer& label, const Point& tip, const Point& direction,
                 double distance, const Box& area, std::vector<Box>& taken) {
  const Point away = direction.norm() > 1e-9 ? Point(direction.normalized()) : Point(0, -1);
  const Box size = boxOf(label);
  for (const double factor : kDistances) {
    for (const double turn : kTurns) {
      const Point middle = tip + Eigen::Rotation2Dd(turn) * away * factor * distance;
      const Point corner = middle - Point(size.width / 2, size.height / 2);
      const Box box = size.moved(corner);
      if (!isFree(box, area, taken)) continue;
      canvas.write(label, corner);
      taken.push_back(box);
      return;
    }
  }
}

void stackUpward(std::span<double> middles, double height, double bottom) {
  double lowest = bottom - height / 2;
  for (double& middle : middles) {
    middle = std::min(middle, lowest);
    lowest = middle - height;
  }
}

}  // namespace rotatebook::overlay
