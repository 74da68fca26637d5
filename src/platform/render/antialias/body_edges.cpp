#include "render/antialias/body_edges.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <Eigen/Geometry>

namespace rotatebook::render {
namespace {

using Eigen::Vector3f;
using Eigen::Vector4d;

/// Numbers the vertices' positions: vertices at one position share a number, whatever their normals
/// and texture coordinates.
std::vector<std::uint32_t> positionNumbers(const std::vector<geometry::MeshVertex>& vertices) {
  constexpr float kFineness = 1e5F;
  std::map<std::array<long, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> numbers;
  for (const geometry::MeshVertex& vertex : vertices) {
    std::array<long, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) {
      key[i] = std::lround(kFineness * vertex.position[static_cast<Eigen::Index>(i)]);
    }
    numbers.push_back(
        known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second);
  }
  return numbers;
}

/// Returns a clip-space point's distance in front of the near plane, up to a constant factor.
double nearDistance(const Vector4d& point) {
  return point.z() + point.w();
}

/// Returns where the line between two points on either side of the near plane crosses it.
Vector4d nearCrossing(const Vector4d& a, const Vector4d& b) {
  return a + nearDistance(a) / (nearDistance(a) - nearDistance(b)) * (b - a);
}

/// A triangle or a line after clipping: the first `count` of the corners.
struct Clipped {
  std::array<Vector4d, 4> corners;
  std::size_t count = 0;
};

/// Clips a triangle, or a line given as a polygon of two corners, against the near plane.
template <std::size_t kCount>
Clipped clipToNearPlane(const std::array<Vector4d, kCount>& corners) {
  Clipped clipped;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Vector4d &here = corners[i], &next = corners[(i + 1) % kCount];
    if (nearDistance(here) > 0) clipped.corners[clipped.count++] = here;
    if ((nearDistance(here) > 0) != (nearDistance(next) > 0)) {
      clipped.corners[clipped.count++] = nearCrossing(here, next);
    }
  }
  return clipped;
}

/// Projects a clip-space point to pixels and a depth.
Vector3f onPicture(const Vector4d& point, const EdgePixels& pixels) {
  const Eigen::Vector3d ndc = point.hnormalized();
  return {static_cast<float>((ndc.x() + 1) / 2 * pixels.width()),
          static_cast<float>((ndc.y() + 1) / 2 * pixels.height()), static_cast<float>(ndc.z())};
}

/// Returns the triangle's winding: 1 from x to y, else -1.
int windingOf(const ScreenTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0 ? 1 : -1;
}

}  // namespace

BodyEdges::BodyEdges(const geometry::Mesh& mesh) {
  for (const geometry::MeshVertex& vertex : mesh.vertices)
    cageWeights_.push_back(geometry::trilinearWeights(vertex.position));

  // Collect the triangles of all parts
  for (const geometry::MeshPart& part : mesh.parts) {
    const auto& indices = part.triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      triangles_.push_back({{indices[i], indices[i + 1], indices[i + 2]},
                            mesh.vertices[indices[i + 2]].surfaceId,
                            part.hidden,
                            part.stripOf[i / 3]});
    }
  }

  // Pair the triangles that share a side
  const std::vector<std::uint32_t> numbers = positionNumbers(mesh.vertices);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = triangles_[i].vertices[side];
      const std::uint32_t b = triangles_[i].vertices[(side + 1) % 3];
      const auto [found, isNew] =
          known.try_emplace(std::minmax(numbers[a], numbers[b]), edges_.size());
      // A third triangle on a side gets an edge of its own.
      if (isNew || edges_[found->second].second) {
        edges_.push_back({{a, b}, i, {}, false});
      } else {
        Edge& edge = edges_[found->second];
        edge.second = i;
        edge.smooth =
            edge.ends == std::array{b, a} && triangles_[edge.first].strip == triangles_[i].strip;
      }
    }
  }
}

void BodyEdges::find(const body::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
                     std::span<const ScreenStrip> strips, EdgePixels& pixels,
                     std::vector<ScreenTriangle>& triangles) const {
  // Transform the vertices to clip space
  const Eigen::Matrix<double, 4, 8> clip = clipFromWorld * cage.colwise().homogeneous();
  std::vector<Vector4d> points;
  points.reserve(cageWeights_.size());
  for (const auto& weights : cageWeights_) points.emplace_back(clip * weights);

  // Add the triangles that are drawn, and keep the winding of each, 0 if it isn't drawn
  std::vector<int> windings;
  windings.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) {
    windings.push_back(addTriangle(triangle, points, winding, strips, pixels, triangles));
  }

  for (const Edge& edge : edges_) {
    // Skip edges between two hidden triangles, and edges inside one smooth surface
    const int first = windings[edge.first], second = edge.second ? windings[*edge.second] : 0;
    if (first == 0 && second == 0) continue;
    const bool inside =
        first == second && (edge.smooth || surfaceIdOf(triangles_[edge.first], strips) ==
                                               surfaceIdOf(triangles_[*edge.second], strips));
    if (inside) continue;

    // Clip the edge against the near plane and add the pixels that it crosses
    const Clipped line = clipToNearPlane(std::array{points[edge.ends[0]], points[edge.ends[1]]});
    if (line.count < 2) continue;
    pixels.addLine(onPicture(line.corners[0], pixels).head<2>(),
                   onPicture(line.corners[1], pixels).head<2>());
  }
}

float BodyEdges::surfaceIdOf(const Triangle& triangle, std::span<const ScreenStrip> strips) {
  const bool isNarrow = triangle.strip < strips.size() && strips[triangle.strip].narrow;
  return isNarrow ? static_cast<float>(geometry::kMaxSurfaceId + 1 + triangle.strip)
                  : triangle.surfaceId;
}

int BodyEdges::addTriangle(const Triangle& triangle, const std::vector<Vector4d>& points,
                           int winding, std::span<const ScreenStrip> strips,
                           const EdgePixels& pixels, std::vector<ScreenTriangle>& triangles) {
  if (triangle.hidden && winding != 0) return 0;

  // Clip the triangle against the near plane
  const auto& [a, b, c] = triangle.vertices;
  const Clipped polygon = clipToNearPlane(std::array{points[a], points[b], points[c]});

  // Split the remaining polygon into a fan of triangles, and reject it if it faces away
  int ownWinding = 0;
  for (std::size_t i = 2; i < polygon.count; ++i) {
    const ScreenTriangle piece{
        {onPicture(polygon.corners[0], pixels), onPicture(polygon.corners[i - 1], pixels),
         onPicture(polygon.corners[i], pixels)},
        surfaceIdOf(triangle, strips)};
    ownWinding = windingOf(piece);
    if (winding != 0 && ownWinding != winding) return 0;
    triangles.push_back(piece);
  }
  return ownWinding;
}

}  // namespace rotatebook::render
