#include "body/triangle_mesh.h"

#include <bit>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::body {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// A table of positions with open addressing, at most half full.
class PointTable {
 public:
  explicit PointTable(std::size_t count) : slots_(std::bit_ceil(2 * count + 2), kNone) {}

  /// Returns the index of the point in `points`, to which it is added if it is new.
  std::uint32_t indexOf(const Eigen::Vector3d& point, std::vector<Eigen::Vector3d>& points) {
    std::size_t slot = hashOf(point) & (slots_.size() - 1);
    while (slots_[slot] != kNone && points[slots_[slot]] != point)
      slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot] == kNone) {
      slots_[slot] = static_cast<std::uint32_t>(points.size());
      points.push_back(point);
    }
    return slots_[slot];
  }

 private:
  static std::size_t hashOf(const Eigen::Vector3d& point) {
    std::uint64_t hash = 0;
    for (const double number : point) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15;  // -0 is 0
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }

  std::vector<std::uint32_t> slots_;
};

void requireUsable(const TriangleMesh& mesh, std::size_t triangle, std::uint32_t point) {
  const std::string which = "triangle " + std::to_string(triangle + 1);
  if (point >= mesh.points.size()) {
    throw InputError(which + " names point " + std::to_string(point + 1) + ", but there are " +
                     std::to_string(mesh.points.size()) + "; export the mesh again");
  }
  for (const double number : mesh.points[point]) {
    if (std::isfinite(number)) continue;
    throw InputError(which + " has a corner with the coordinate " + shortestText(number) +
                     "; coordinates must be finite numbers");
  }
}

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.triangles.reserve(mesh.triangles.size());
  PointTable table(mesh.points.size());
  std::vector<std::uint32_t> indices(mesh.points.size(), kNone);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto& triangle = result.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t point = mesh.triangles[i][corner];
      if (point >= indices.size() || indices[point] == kNone) {
        requireUsable(mesh, i, point);
        indices[point] = table.indexOf(mesh.points[point], result.points);
      }
      triangle[corner] = indices[point];
    }
  }
  return result;
}

Box boxAround(std::span<const Eigen::Vector3d> points) {
  Box box{points.front(), points.front()};
  for (const Eigen::Vector3d& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

void append(const TriangleMesh& added, TriangleMesh& into) {
  const auto first = static_cast<std::uint32_t>(into.points.size());
  into.points.insert(into.points.end(), added.points.begin(), added.points.end());
  for (const auto& [a, b, c] : added.triangles)
    into.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace rotatebook::body
