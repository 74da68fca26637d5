#include "body/shells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "base/disjoint_sets.h"
#include "body/mesh_edges.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

/// Angles around an edge that are so near are the same: of faces that lie on each other. [of 4]
constexpr double kSameAngle = 1e-9;

/// Returns a number from 0 to below 4 that grows with the angle of (x, y).
double angleNumber(double x, double y) {
  const double sum = std::fabs(x) + std::fabs(y);
  const double share = sum > 0 ? y / sum : 0;
  if (x < 0) return 2 - share;
  return share < 0 ? 4 + share : share;
}

/// A side, and where its triangle is around the edge.
struct Spoke {
  double angle;
  Side side;
};

/// Returns the sides of an edge by their angles, counter-clockwise as seen against the edge, so
/// that a triangle that runs along the edge has the body before it, and one that runs back behind.
std::vector<Spoke> spokesOf(const TriangleMesh& mesh, std::uint32_t begin,
                            std::span<const Side> sides) {
  const Vector3d along = mesh.points[sides[0].end] - mesh.points[begin];
  const auto across = [&](const Side& side) -> Vector3d {
    const Vector3d to = mesh.points[oppositeOf(mesh, side)] - mesh.points[begin];
    return to - along * (to.dot(along) / along.squaredNorm());
  };
  const Vector3d x = across(sides[0]) * along.norm(), y = along.cross(across(sides[0]));
  std::vector<Spoke> spokes;
  for (const Side& side : sides) {
    const Vector3d to = across(side);
    const double angle = angleNumber(to.dot(x), to.dot(y));
    spokes.push_back({angle > 4 - kSameAngle ? angle - 4 : angle, side});
  }
  std::ranges::stable_sort(spokes, {}, &Spoke::angle);
  return spokes;
}

/// Finds the pairs of an edge's sides that have the body between them.
class EdgePairs {
 public:
  explicit EdgePairs(std::vector<Spoke> spokes) : spokes_(std::move(spokes)) {
    if (!rotateToOutside()) beginInside();
    for (std::size_t i = 0; i < spokes_.size();) i = visitGroup(i);
  }

  const std::vector<std::array<std::uint32_t, 2>>& triangles() const { return pairs_; }
  const std::optional<std::array<std::size_t, 2>>& overlap() const { return overlap_; }

 private:
  std::size_t groupEnd(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < spokes_.size() && spokes_[end].angle - spokes_[begin].angle <= kSameAngle) ++end;
    return end;
  }

  /// Begins with the group before which fewest bodies are entered and not left. Returns false if
  /// that is alike all around.
  bool rotateToOutside() {
    std::ptrdiff_t depth = 0, least = 0, most = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < spokes_.size();) {
      const std::size_t end = groupEnd(i);
      for (; i < end; ++i) depth += spokes_[i].side.isForward ? -1 : 1;
      most = std::max(most, depth);
      if (depth >= least) continue;
      least = depth;
      first = end;
    }
    for (std::size_t i = 0; i < first; ++i) spokes_[i].angle += 4;
    std::rotate(spokes_.begin(),
                spokes_.begin() + static_cast<std::ptrdiff_t>(first % spokes_.size()),
                spokes_.end());
    return most > least;
  }

  /// A body is entered last where all faces lie on each other, as walls in a body do.
  void beginInside() {
    const auto last = std::find_if(spokes_.rbegin(), spokes_.rend(),
                                   [](const Spoke& spoke) { return !spoke.side.isForward; });
    enteredFirst_ = last->side.number;
    open_.push_back(last->side.triangle());
  }

  /// Leaves bodies, enters others, and leaves those that have no thickness; returns the next group.
  std::size_t visitGroup(std::size_t begin) {
    const std::size_t end = groupEnd(begin);
    std::vector<std::uint32_t> leaving, entering;
    for (std::size_t i = begin; i < end; ++i) {
      const Side& side = spokes_[i].side;
      if (side.number != enteredFirst_)
        (side.isForward ? leaving : entering).push_back(side.triangle());
    }
    const auto leave = [&] {
      for (; !leaving.empty() && !open_.empty(); leaving.pop_back(), open_.pop_back())
        pairs_.push_back({open_.back(), leaving.back()});
    };
    leave();
    open_.insert(open_.end(), entering.begin(), entering.end());
    leave();
    if (open_.size() > 1 && !overlap_) {
      const auto [one, other] = std::minmax(open_[open_.size() - 2], open_.back());
      overlap_ = {one, other};
    }
    return end;
  }

  std::vector<Spoke> spokes_;
  std::optional<std::uint32_t> enteredFirst_{};  // A side's number.
  std::vector<std::uint32_t> open_;  // Triangles behind which the body is, not yet left.
  std::vector<std::array<std::uint32_t, 2>> pairs_;
  std::optional<std::array<std::size_t, 2>> overlap_;
};

}  // namespace

Shells shellsOf(const TriangleMesh& mesh) {
  Shells shells;
  DisjointSets sets(mesh.triangles.size());
  MeshEdges(mesh).forEach([&](std::uint32_t begin, std::span<const Side> sides) {
    if (sides.size() <= 2) {
      sets.join(sides.front().triangle(), sides.back().triangle());
      return;
    }
    const EdgePairs pairs(spokesOf(mesh, begin, sides));
    for (const auto& [one, other] : pairs.triangles()) sets.join(one, other);
    if (!shells.overlap) shells.overlap = pairs.overlap();
  });
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) shells.count += sets.of(i) == i ? 1 : 0;
  return shells;
}

}  // namespace rotatebook::body
