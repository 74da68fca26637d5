#include "body/lattice.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

/// Returns the smallest whole number not below `x`, unless it is above by rounding alone.
int ceiling(double x) {
  constexpr double kRounding = 1e-9;
  return static_cast<int>(std::ceil(x - kRounding));
}

/// Returns 1 or -1 if the edge from `a` to `b`, seen along x, crosses the ray from (y, z) toward
/// greater y, upward or downward in z; else 0. The edge from `b` to `a` gives the opposite.
int crossing(const Vector3d& a, const Vector3d& b, double y, double z) {
  if ((a.z() <= z) == (b.z() <= z)) return 0;
  const bool isUpward = a.z() <= z;
  const Vector3d& low = isUpward ? a : b;
  const Vector3d& high = isUpward ? b : a;
  const double at = low.y() + (z - low.z()) / (high.z() - low.z()) * (high.y() - low.y());
  if (!(at > y)) return 0;
  return isUpward ? 1 : -1;
}

/// A triangle, and what it takes to find where lines along x go through it.
class SeenAlongX {
 public:
  SeenAlongX(const Vector3d& a, const Vector3d& b, const Vector3d& c)
      : a_(a), b_(b), c_(c), normal_((b - a).cross(c - a)) {}

  Vector3d low() const { return a_.cwiseMin(b_).cwiseMin(c_); }
  Vector3d high() const { return a_.cwiseMax(b_).cwiseMax(c_); }

  /// Returns how often its outline winds around the line, counter-clockwise: 1, 0 or -1.
  int winding(double y, double z) const {
    return crossing(a_, b_, y, z) + crossing(b_, c_, y, z) + crossing(c_, a_, y, z);
  }
  /// Returns where the line goes through its plane, within the triangle's x.
  double x(double y, double z) const {
    const double slope = normal_.y() * (y - a_.y()) + normal_.z() * (z - a_.z());
    const double x = normal_.x() != 0 ? a_.x() - slope / normal_.x() : a_.x();
    return std::clamp(x, low().x(), high().x());
  }

 private:
  Vector3d a_, b_, c_, normal_;
};

/// Returns the points from the first at or above `low` to the first above `high`, along an axis.
std::array<int, 2> range(const Lattice& lattice, int axis, double low, double high) {
  const auto from = [&](double at) {
    const double cells = std::ceil((at - lattice.first[axis]) / lattice.cell);
    return std::clamp(cells, 0.0, 1.0 * lattice.counts.at(static_cast<std::size_t>(axis)));
  };
  // Take one more on each side, against rounding: the outline decides
  const int count = lattice.counts.at(static_cast<std::size_t>(axis));
  return {std::max(0, static_cast<int>(from(low)) - 1),
          std::min(count, static_cast<int>(from(high)) + 2)};
}

/// Adds the surface that a line along x crosses to all points before it.
void addCrossing(const SeenAlongX& triangle, const Lattice& lattice, int iy, int iz,
                 std::vector<int>& windings) {
  const Vector3d row = lattice.point(0, iy, iz);
  const int winding = triangle.winding(row.y(), row.z());
  if (winding == 0) return;
  const double x = triangle.x(row.y(), row.z());
  for (int ix = 0; ix < lattice.counts[0] && lattice.point(ix, iy, iz).x() < x; ++ix)
    windings[lattice.index(ix, iy, iz)] += winding;
}

}  // namespace

Lattice latticeIn(const Vector3d& low, const Vector3d& high, int cells) {
  const Vector3d size = high - low;
  Lattice lattice;
  lattice.cell = size.maxCoeff() / cells;
  Vector3d span;
  for (int axis = 0; axis < 3; ++axis) {
    const int count = std::max(1, ceiling(size[axis] / lattice.cell));
    lattice.counts.at(static_cast<std::size_t>(axis)) = count;
    span[axis] = lattice.cell * (count - 1);
  }
  lattice.first = (low + high) / 2 - span / 2;
  return lattice;
}

std::vector<int> windingNumbers(const TriangleMesh& mesh, const Lattice& lattice) {
  std::vector<int> windings(lattice.size(), 0);
  for (const auto& corners : mesh.triangles) {
    const SeenAlongX triangle(mesh.points[corners[0]], mesh.points[corners[1]],
                              mesh.points[corners[2]]);
    const auto [firstY, endY] = range(lattice, 1, triangle.low().y(), triangle.high().y());
    const auto [firstZ, endZ] = range(lattice, 2, triangle.low().z(), triangle.high().z());
    for (int iz = firstZ; iz < endZ; ++iz) {
      for (int iy = firstY; iy < endY; ++iy) addCrossing(triangle, lattice, iy, iz, windings);
    }
  }
  return windings;
}

}  // namespace rotatebook::body
