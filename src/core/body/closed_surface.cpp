#include "body/closed_surface.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

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

/// The point that is nearest to an open edge.
struct Neighbour {
  double distance = std::numeric_limits<double>::infinity();
  double fromEnd = 0;  ///< Its distance from the nearer end of the edge.
  std::uint32_t point = 0;
};

Neighbour nearestTo(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Vector3d& begin = mesh.points[a];
  const Vector3d along = mesh.points[b] - begin;
  Neighbour nearest;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (i == a || i == b) continue;
    const Vector3d from = mesh.points[i] - begin;
    const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (from - share * along).norm();
    if (distance >= nearest.distance) continue;
    nearest = {distance, std::min(from.norm(), (from - along).norm()), i};
  }
  return nearest;
}

/// The messages of what is wrong with a mesh.
class Complaint {
 public:
  Complaint(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers)
      : mesh_(mesh), numbers_(numbers) {}

  /// Throws InputError unless the sides of one edge, which begins at `begin`, belong together.
  void requireTogether(std::uint32_t begin, std::span<const Side> sides) const {
    if (belongTogether(mesh_, sides)) return;
    const std::string edge = "the edge from " + pointText(mesh_.points[begin]) + " to " +
                             pointText(mesh_.points[sides[0].end]);
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
    const std::size_t forward = countForward(sides);
    throw InputError(edge + " belongs to " + std::to_string(sides.size()) + " triangles (" +
                     trianglesText(sides) + "), " + std::to_string(forward) +
                     " of which run along it one way and " +
                     std::to_string(sides.size() - forward) +
                     " the other: as many must run either way; take open flaps and single inner "
                     "walls away");
  }

  void requireCorners(std::size_t triangle) const {
    if (!hasCornerTwice(mesh_.triangles[triangle])) return;
    const auto [a, b, c] = mesh_.triangles[triangle];
    throw InputError("triangle " + numberOf(triangle) + " has the corner " +
                     pointText(mesh_.points[a == b ? a : c]) +
                     " twice; take it away, and merge the points of its short edge");
  }

 private:
  std::string numberOf(std::size_t triangle) const {
    return std::to_string((numbers_.empty() ? triangle : numbers_[triangle]) + 1);
  }

  std::string trianglesText(std::span<const Side> sides) const {
    constexpr std::size_t kShown = 4;
    std::string text = "triangles ";
    for (std::size_t i = 0; i < std::min(sides.size(), kShown); ++i)
      text += (i == 0 ? "" : ", ") + numberOf(sides[i].triangle());
    return text + (sides.size() > kShown ? " and others" : "");
  }

  /// Returns what is wrong at an edge of one triangle: a hole, or points that don't meet.
  std::string remedyAlone(std::uint32_t a, std::uint32_t b) const {
    constexpr double kOn = 1e-6, kNear = 1e-4;  // of the size: no hole that is seen
    const auto [low, high] = boxAround(mesh_.points);
    const double size = (high - low).maxCoeff();
    const Neighbour nearest = nearestTo(mesh_, a, b);
    const std::string point = pointText(mesh_.points[nearest.point]);
    if (nearest.fromEnd <= kNear * size) {
      return "another point, " + point + ", is only " + roundedText(nearest.fromEnd, 2) +
             " from its end; merge points that are so near each other";
    }
    if (nearest.distance <= kOn * size)
      return "the point " + point + " lies on it; divide the edge there, as its neighbours do";
    return "the surface is open there; close the hole";
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> numbers_;
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
  const Complaint complaint(mesh, numbers);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) complaint.requireCorners(i);
  bool isSheet = true;
  MeshEdges(mesh).forEach([&](std::uint32_t begin, std::span<const Side> sides) {
    complaint.requireTogether(begin, sides);
    isSheet = isSheet && areReversed(mesh, sides);
  });
  if (isSheet) {
    throw InputError(
        "each triangle has another on it that faces the other way: the surface encloses nothing; "
        "give it a thickness");
  }
}

}  // namespace rotatebook::body
