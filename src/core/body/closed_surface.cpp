#include "body/closed_surface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/number_text.h"
#include "body/mesh_edges.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;

std::size_t countForward(std::span<const Side> sides) {
  return static_cast<std::size_t>(std::ranges::count(sides, true, &Side::isForward));
}

/// Returns two of an edge's triangles that have the same corners in the same order, if any do.
std::optional<std::array<std::uint32_t, 2>> sameTriangles(const TriangleMesh& mesh,
                                                          std::span<const Side> sides) {
  if (sides.size() < 3) return std::nullopt;
  const auto key = [&](const Side& side) {
    return std::tuple(side.isForward, oppositeOf(mesh, side), side.number);
  };
  std::vector<Side> sorted(sides.begin(), sides.end());
  std::sort(sorted.begin(), sorted.end(),
            [&](const Side& a, const Side& b) { return key(a) < key(b); });
  const auto same =
      std::adjacent_find(sorted.begin(), sorted.end(), [&](const Side& a, const Side& b) {
        return a.isForward == b.isForward && oppositeOf(mesh, a) == oppositeOf(mesh, b);
      });
  if (same == sorted.end()) return std::nullopt;
  return std::array{same->triangle(), (same + 1)->triangle()};
}

/// Returns two of an edge's three triangles that lie on each other and face opposite ways, if any
/// do: the second one is too many.
std::optional<std::array<std::uint32_t, 2>> backToBack(const TriangleMesh& mesh,
                                                       std::span<const Side> sides) {
  if (sides.size() != 3) return std::nullopt;
  const bool isSingleForward = countForward(sides) == 1;
  const auto single = std::ranges::find(sides, isSingleForward, &Side::isForward);
  if (single == sides.end()) return std::nullopt;
  for (const Side& other : sides) {
    if (other.isForward != isSingleForward && oppositeOf(mesh, other) == oppositeOf(mesh, *single))
      return std::array{single->triangle(), other.triangle()};
  }
  return std::nullopt;
}

bool belongTogether(const TriangleMesh& mesh, std::span<const Side> sides) {
  return 2 * countForward(sides) == sides.size() && !sameTriangles(mesh, sides);
}

/// Returns whether an edge's triangles, of which half run each way, are each the reverse of
/// another.
bool areReversed(const TriangleMesh& mesh, std::span<const Side> sides) {
  std::array<std::vector<std::uint32_t>, 2> corners;
  for (const Side& side : sides)
    corners.at(side.isForward ? 1 : 0).push_back(oppositeOf(mesh, side));
  for (auto& list : corners) std::sort(list.begin(), list.end());
  return corners[0] == corners[1];
}

bool hasCornerTwice(const std::array<std::uint32_t, 3>& triangle) {
  const auto [a, b, c] = triangle;
  return a == b || b == c || c == a;
}

std::string pointText(const Vector3d& point) {
  return "(" + shortestText(point.x()) + ", " + shortestText(point.y()) + ", " +
         shortestText(point.z()) + ")";
}

std::string fileNumberOf(std::span<const std::uint32_t> numbers, std::size_t triangle) {
  return std::to_string((numbers.empty() ? triangle : numbers[triangle]) + 1);
}

/// A point beside an edge.
struct Neighbour {
  double distance = std::numeric_limits<double>::infinity();
  double fromEnd = 0;  ///< Its distance from the nearer end of the edge.
  std::uint32_t point = 0;
};

/// An edge, and the distances in which points are taken to be at it.
class OpenEdge {
 public:
  OpenEdge(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, double size)
      : mesh_(mesh), a_(a), b_(b), along_(mesh.points[b] - mesh.points[a]), size_(size) {}

  /// Return whether a point that is nearer to the edge than others is taken to be its end, or to
  /// lie on it: so near to it that no hole would be seen, nor as large as the triangles there.
  bool hasAtEnd(const Neighbour& one) const {
    return one.fromEnd <= std::min(1e-4 * size_, 0.1 * along_.norm());
  }
  bool hasInside(const Neighbour& one) const {
    return one.distance <= std::min(1e-6 * size_, 0.01 * along_.norm()) && !hasAtEnd(one);
  }

  /// Returns its length, if that is no more than points that should be one may be apart; else 0.
  double lengthIfTiny() const {
    const double length = along_.norm();
    return length <= 1e-6 * size_ ? length : 0;
  }

  Neighbour at(std::uint32_t point) const {
    const Vector3d from = mesh_.points[point] - mesh_.points[a_];
    const double share = std::clamp(from.dot(along_) / along_.squaredNorm(), 0.0, 1.0);
    return {(from - share * along_).norm(), std::min(from.norm(), (from - along_).norm()), point};
  }

  Neighbour nearest() const {
    Neighbour nearest;
    for (std::uint32_t i = 0; i < mesh_.points.size(); ++i) {
      if (i == a_ || i == b_) continue;
      const Neighbour one = at(i);
      if (one.distance < nearest.distance) nearest = one;
    }
    return nearest;
  }

  /// Returns the end of another edge that lies on this one, in which they have the same direction;
  /// nothing without.
  std::optional<std::uint32_t> endOfOther(std::uint32_t c, std::uint32_t d) const {
    const Vector3d other = (mesh_.points[d] - mesh_.points[c]).normalized();
    constexpr double kParallel = 0.01;  // sine of the angle between
    if (!(along_.normalized().cross(other).norm() < kParallel)) return std::nullopt;
    for (const std::uint32_t end : {c, d}) {
      if (end != a_ && end != b_ && hasInside(at(end))) return end;
    }
    return std::nullopt;
  }

 private:
  const TriangleMesh& mesh_;
  std::uint32_t a_, b_;
  Vector3d along_;
  double size_;  // Of the mesh.
};

/// The messages of what is wrong with a mesh.
class Complaint {
 public:
  /// Takes a mesh none of whose triangles has a corner twice.
  Complaint(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers)
      : mesh_(mesh), numbers_(numbers), edges_(mesh) {}

  void requireAllTogether() const {
    edges_.forEach(
        [&](std::uint32_t begin, std::span<const Side> sides) { requireTogether(begin, sides); });
  }

  /// Throws InputError if each triangle has its reverse.
  void refuseSheet() const {
    bool isSheet = true;
    edges_.forEach([&](std::uint32_t, std::span<const Side> sides) {
      isSheet = isSheet && areReversed(mesh_, sides);
    });
    if (!isSheet) return;
    throw InputError(
        "each triangle has another on it that faces the other way: the surface encloses nothing; "
        "give it a thickness");
  }

 private:
  /// Throws InputError unless the sides of one edge, which begins at `begin`, belong together.
  void requireTogether(std::uint32_t begin, std::span<const Side> sides) const {
    if (belongTogether(mesh_, sides)) return;
    const std::string edge = edgeText(begin, sides[0].end);
    if (sides.size() == 1) {
      throw InputError(edge + " belongs to triangle " + numberOf(sides[0].triangle()) +
                       " alone: " + remedyAlone(begin, sides[0].end));
    }
    if (const auto same = sameTriangles(mesh_, sides)) {
      throw InputError("triangles " + numberOf((*same)[0]) + " and " + numberOf((*same)[1]) +
                       " are the same; take one of them away");
    }
    if (sides.size() == 2) {
      throw InputError(trianglesText(sides) + " run along " + edge +
                       " in the same direction: one of them faces inward; turn its corners round");
    }
    if (const auto two = backToBack(mesh_, sides)) {
      throw InputError("triangles " + numberOf((*two)[0]) + " and " + numberOf((*two)[1]) +
                       " lie on each other and face opposite ways; take triangle " +
                       numberOf((*two)[1]) + " away");
    }
    const std::size_t forward = countForward(sides);
    throw InputError(edge + " belongs to " + std::to_string(sides.size()) + " triangles (" +
                     trianglesText(sides) + "), " + std::to_string(forward) +
                     " of which run along it one way and " +
                     std::to_string(sides.size() - forward) +
                     " the other: as many must run either way; take open flaps and single inner "
                     "walls away");
  }

  std::string edgeText(std::uint32_t a, std::uint32_t b) const {
    return "the edge from " + pointText(mesh_.points[a]) + " to " + pointText(mesh_.points[b]);
  }

  std::string numberOf(std::size_t triangle) const { return fileNumberOf(numbers_, triangle); }

  std::string trianglesText(std::span<const Side> sides) const {
    constexpr std::size_t kShown = 4;
    const bool isAll = sides.size() <= kShown;
    std::string text = "triangles ";
    for (std::size_t i = 0; i < std::min(sides.size(), kShown); ++i) {
      const bool isLast = isAll && i + 1 == sides.size();
      text += (i == 0 ? "" : isLast ? " and " : ", ") + numberOf(sides[i].triangle());
    }
    return text + (isAll ? "" : " and others");
  }

  /// Returns what is wrong at an edge of one triangle: a hole, or points that don't meet.
  std::string remedyAlone(std::uint32_t a, std::uint32_t b) const {
    const auto [low, high] = boxAround(mesh_.points);
    const double size = (high - low).maxCoeff();
    const OpenEdge edge(mesh_, a, b, size);
    if (const double length = edge.lengthIfTiny(); length > 0) {
      return "its ends are only " + roundedText(length, 2) +
             " apart; merge points that are so near each other";
    }
    const Neighbour nearest = edge.nearest();
    const std::string point = pointText(mesh_.points[nearest.point]);
    if (edge.hasAtEnd(nearest)) {
      return "another point, " + point + ", is only " + roundedText(nearest.fromEnd, 2) +
             " from its end; merge points that are so near each other";
    }
    if (edge.hasInside(nearest))
      return "the point " + point + " lies on it; divide the edge there, as its neighbours do";
    const std::string junction = junctionText(a, b, size);
    return junction.empty() ? "the surface is open there; close the hole" : junction;
  }

  /// Returns what is said of an end of an open edge that lies on another one; empty without.
  std::string junctionText(std::uint32_t a, std::uint32_t b, double size) const {
    std::string text;
    edges_.forEach([&](std::uint32_t c, std::span<const Side> sides) {
      if (!text.empty() || sides.size() > 1) return;
      const auto end = OpenEdge(mesh_, c, sides[0].end, size).endOfOther(a, b);
      if (!end) return;
      text = "its end " + pointText(mesh_.points[*end]) + " lies on " + edgeText(c, sides[0].end) +
             " of triangle " + numberOf(sides[0].triangle()) + "; divide that there, too";
    });
    return text;
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> numbers_;
  MeshEdges edges_;
};

}  // namespace

bool isClosed(const TriangleMesh& mesh) {
  if (mesh.triangles.empty() || std::ranges::any_of(mesh.triangles, hasCornerTwice)) return false;
  bool closed = true, isSheet = true;
  MeshEdges(mesh).forEach([&](std::uint32_t, std::span<const Side> sides) {
    closed = closed && belongTogether(mesh, sides);
    isSheet = isSheet && areReversed(mesh, sides);
  });
  return closed && !isSheet;
}

void requireClosed(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers) {
  if (mesh.triangles.empty())
    throw InputError("there are no triangles; export a mesh of triangles");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!hasCornerTwice(mesh.triangles[i])) continue;
    const auto [a, b, c] = mesh.triangles[i];
    throw InputError("triangle " + fileNumberOf(numbers, i) + " has the corner " +
                     pointText(mesh.points[a == b ? a : c]) +
                     " twice; take it away, and merge the points of its short edge");
  }
  const Complaint complaint(mesh, numbers);
  complaint.requireAllTogether();
  complaint.refuseSheet();
}

}  // namespace rotatebook::body
