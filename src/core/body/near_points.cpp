#include "body/near_points.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

/// Points that were kept, in a grid of cells; cells that share a list cost time alone.
class KeptPoints {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  KeptPoints(const std::vector<Vector3d>& points, const Vector3d& low, double reach)
      : points_(points),
        low_(low),
        reach_(reach),
        first_(std::bit_ceil(2 * points.size()), kNone),
        next_(points.size(), kNone) {}

  /// Returns the nearest point within reach, the first of several; kNone if there is none.
  std::uint32_t nearestTo(const Vector3d& point) const {
    // A cell is twice as wide as the reach: half a cell back, it meets two cells along each axis
    const Cell cell = cellOf(point, 0.5);
    std::uint32_t nearest = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) {
      const Cell near{cell[0] + (i & 1), cell[1] + (i >> 1 & 1), cell[2] + (i >> 2)};
      for (std::uint32_t at = first_[slotOf(near)]; at != kNone; at = next_[at]) {
        const double distance = (points_[at] - point).norm();
        if (!(distance < reach_) || distance > least) continue;
        if (distance == least && at >= nearest) continue;
        least = distance;
        nearest = at;
      }
    }
    return nearest;
  }

  void add(std::uint32_t index) {
    std::uint32_t& first = first_[slotOf(cellOf(points_[index], 0))];
    next_[index] = first;
    first = index;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cellOf(const Vector3d& point, double back) const {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      const double cells = (point[axis] - low_[axis]) / (2 * reach_);
      cell.at(i) = static_cast<std::int64_t>(std::floor(cells - back));
    }
    return cell;
  }

  std::size_t slotOf(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t number : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash) & (first_.size() - 1);
  }

  const std::vector<Vector3d>& points_;
  Vector3d low_;
  double reach_;
  std::vector<std::uint32_t> first_, next_;  // By slot, and by point.
};

}  // namespace

JoinedPoints joinNearPoints(TriangleMesh& mesh) {
  JoinedPoints joined;
  if (mesh.points.empty()) return joined;
  const auto [low, high] = boxAround(mesh.points);
  const double reach = kNearPoints * (high - low).maxCoeff();
  if (!(reach > 0 && std::isfinite(1 / reach) && std::isfinite(reach))) return joined;
  KeptPoints kept(mesh.points, low, reach);
  std::vector<std::uint32_t> points(mesh.points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t nearest = kept.nearestTo(mesh.points[i]);
    points[i] = nearest == KeptPoints::kNone ? i : nearest;
    if (points[i] == i) {
      kept.add(i);
    } else {
      ++joined.count;
      joined.distance = std::max(joined.distance, (mesh.points[i] - mesh.points[nearest]).norm());
    }
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = points[corner];
  }
  return joined;
}

}  // namespace rotatebook::body
