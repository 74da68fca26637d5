#include "body/closed_surface.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::body {
namespace {

/// A triangle's side from its smaller point's index to `end`, the larger one.
struct Side {
  std::uint32_t end;
  std::uint32_t triangle;
  bool isForward;  ///< The triangle runs from the smaller to the larger index.
};

std::string triangleText(std::uint32_t triangle) {
  return "triangle " + std::to_string(triangle + 1);
}

std::string pointText(const Eigen::Vector3d& point) {
  return "(" + shortestText(point.x()) + ", " + shortestText(point.y()) + ", " +
         shortestText(point.z()) + ")";
}

std::string trianglesText(std::span<const Side> sides) {
  constexpr std::size_t kShown = 4;
  std::string text = "triangles ";
  for (std::size_t i = 0; i < std::min(sides.size(), kShown); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(sides[i].triangle + 1);
  return text + (sides.size() > kShown ? " and others" : "");
}

/// Throws InputError unless the sides of one edge, which begins at `begin`, belong together.
void requirePair(const TriangleMesh& mesh, std::size_t begin, std::span<const Side> sides) {
  if (sides.size() == 2 && sides[0].isForward != sides[1].isForward) return;
  const std::string edge = "the edge from " + pointText(mesh.points[begin]) + " to " +
                           pointText(mesh.points[sides[0].end]);
  if (sides.size() == 1) {
    throw InputError(edge + " belongs to " + triangleText(sides[0].triangle) +
                     " alone: the surface is open there; close the hole");
  }
  if (sides.size() == 2) {
    throw InputError(trianglesText(sides) + " run along " + edge +
                     " in the same direction: one of them faces inward; turn its corners round");
  }
  throw InputError(edge + " belongs to " + std::to_string(sides.size()) + " triangles (" +
                   trianglesText(sides) +
                   "): a body's edge has two; take doubled faces and inner walls away");
}

void requireTriangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw InputError("there are no triangles; export a mesh of triangles");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    if (a != b && b != c && c != a) continue;
    throw InputError("triangle " + std::to_string(i + 1) + " has the corner " +
                     pointText(mesh.points[a == b ? a : c]) +
                     " twice; take it away, and merge the points of its short edge");
  }
}

/// Sides in the order of their smaller point, and for each point where its sides begin.
struct SidesByPoint {
  std::vector<std::size_t> begins;
  std::vector<Side> sides;
};

template <typename Visit>
void visitSides(const TriangleMesh& mesh, const Visit& visit) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = mesh.triangles[i][corner], b = mesh.triangles[i][(corner + 1) % 3];
      visit(std::min(a, b), Side{std::max(a, b), static_cast<std::uint32_t>(i), a < b});
    }
  }
}

SidesByPoint sidesByPoint(const TriangleMesh& mesh) {
  SidesByPoint result{std::vector<std::size_t>(mesh.points.size() + 1),
                      std::vector<Side>(3 * mesh.triangles.size())};
  visitSides(mesh, [&](std::uint32_t begin, const Side&) { ++result.begins[begin + 1]; });
  std::partial_sum(result.begins.begin(), result.begins.end(), result.begins.begin());
  std::vector<std::size_t> next(result.begins.begin(), result.begins.end() - 1);
  visitSides(mesh,
             [&](std::uint32_t begin, const Side& side) { result.sides[next[begin]++] = side; });
  return result;
}

}  // namespace

void requireClosed(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  SidesByPoint all = sidesByPoint(mesh);
  const auto key = [](const Side& side) { return std::pair(side.end, side.triangle); };
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    const std::span<Side> own(all.sides.data() + all.begins[point],
                              all.begins[point + 1] - all.begins[point]);
    std::sort(own.begin(), own.end(),
              [&](const Side& a, const Side& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < own.size();) {
      std::size_t end = i + 1;
      while (end < own.size() && own[end].end == own[i].end) ++end;
      requirePair(mesh, point, own.subspan(i, end - i));
      i = end;
    }
  }
}

std::size_t countShells(const TriangleMesh& mesh) {
  DisjointSets shells(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    shells.join(a, b);
    shells.join(b, c);
  }
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) count += shells.of(i) == i ? 1 : 0;
  return count;
}

}  // namespace rotatebook::body
