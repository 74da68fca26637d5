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

/// The same for vertices at one place, whatever their normals and texture coordinates.
std::vector<std::uint32_t> placeNumbers(const std::vector<BookVertex>& vertices) {
  constexpr float kFineness = 1e5F;
  std::map<std::array<long, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> numbers;
  for (const BookVertex& vertex : vertices) {
    std::array<long, 3> key{};
    for (std::size_t i = 0; i < 3; ++i) {
      key[i] = std::lround(kFineness * vertex.position[static_cast<Eigen::Index>(i)]);
    }
    numbers.push_back(
        known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second);
  }
  return numbers;
}

/// How far a point of clip space is in front of the near plane, as a multiple of something.
double ahead(const Vector4d& point) {
  return point.z() + point.w();
}

/// Where the line between points on either side of the near plane goes through it.
Vector4d onNearPlane(const Vector4d& a, const Vector4d& b) {
  return a + ahead(a) / (ahead(a) - ahead(b)) * (b - a);
}

/// A triangle, or a line, as the near plane has left it: the first `count` of the corners.
struct Cut {
  std::array<Vector4d, 4> corners;
  std::size_t count = 0;
};

/// What of a triangle, or of a line given as one of two corners, lies in front of the near plane.
template <std::size_t kCount>
Cut inFront(const std::array<Vector4d, kCount>& corners) {
  Cut seen;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Vector4d &here = corners[i], &next = corners[(i + 1) % kCount];
    if (ahead(here) > 0) seen.corners[seen.count++] = here;
    if ((ahead(here) > 0) != (ahead(next) > 0)) {
      seen.corners[seen.count++] = onNearPlane(here, next);
    }
  }
  return seen;
}

/// From clip space to pixels, and a depth.
Vector3f onPicture(const Vector4d& point, const EdgePixels& pixels) {
  const Eigen::Vector3d seen = point.hnormalized();
  return {static_cast<float>((seen.x() + 1) / 2 * pixels.width()),
          static_cast<float>((seen.y() + 1) / 2 * pixels.height()), static_cast<float>(seen.z())};
}

/// Which way the triangle turns: 1 from x to y, else -1.
int windingOf(const ScreenTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0 ? 1 : -1;
}

}  // namespace

BodyEdges::BodyEdges(const BookMesh& mesh) {
  for (const BookVertex& vertex : mesh.vertices)
    shares_.push_back(sharesOfCorners(vertex.position));
  for (std::size_t part = 0; part < kBookPartCount; ++part) {
    const auto& indices = mesh.triangles[part];
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      triangles_.push_back({{indices[i], indices[i + 1], indices[i + 2]},
                            mesh.vertices[indices[i]].surfaceId,
                            part == static_cast<std::size_t>(BookPart::Lining),
                            mesh.stripOf[part][i / 3]});
    }
  }
  const std::vector<std::uint32_t> numbers = placeNumbers(mesh.vertices);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = triangles_[i].vertices[side];
      const std::uint32_t b = triangles_[i].vertices[(side + 1) % 3];
      const auto [found, isNew] =
          known.try_emplace(std::minmax(numbers[a], numbers[b]), edges_.size());
      // A third triangle has its side for itself.
      if (isNew || edges_[found->second].second) {
        edges_.push_back({{a, b}, i, {}});
      } else {
        edges_[found->second].second = i;
      }
    }
  }
}

void BodyEdges::find(const physics::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
                     std::span<const ScreenStrip> strips, EdgePixels& pixels,
                     std::vector<ScreenTriangle>& triangles) const {
  const Eigen::Matrix<double, 4, 8> clip = clipFromWorld * cage.colwise().homogeneous();
  std::vector<Vector4d> points;
  points.reserve(shares_.size());
  for (const auto& shares : shares_) points.emplace_back(clip * shares);
  std::vector<int> turns;  // of all triangles; 0: isn't drawn
  turns.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) {
    turns.push_back(addTriangle(triangle, points, winding, strips, pixels, triangles));
  }
  for (const Edge& edge : edges_) {
    const int first = turns[edge.first], second = edge.second ? turns[*edge.second] : 0;
    if (first == 0 && second == 0) continue;
    const bool inside = first == second && surfaceOf(triangles_[edge.first], strips) ==
                                               surfaceOf(triangles_[*edge.second], strips);
    if (inside) continue;
    const Cut seen = inFront(std::array{points[edge.ends[0]], points[edge.ends[1]]});
    if (seen.count < 2) continue;
    pixels.addLine(onPicture(seen.corners[0], pixels).head<2>(),
                   onPicture(seen.corners[1], pixels).head<2>());
  }
}

float BodyEdges::surfaceOf(const Triangle& triangle, std::span<const ScreenStrip> strips) {
  if (triangle.strip >= strips.size() || !strips[triangle.strip].narrow) return triangle.surface;
  return static_cast<float>(kMaxSurfaceId + 1 + triangle.strip);
}

int BodyEdges::addTriangle(const Triangle& triangle, const std::vector<Vector4d>& points,
                           int winding, std::span<const ScreenStrip> strips,
                           const EdgePixels& pixels, std::vector<ScreenTriangle>& triangles) {
  if (triangle.lining && winding != 0) return 0;
  const auto& [a, b, c] = triangle.vertices;
  const Cut seen = inFront(std::array{points[a], points[b], points[c]});
  int turn = 0;
  for (std::size_t i = 2; i < seen.count; ++i) {
    const ScreenTriangle piece{
        {onPicture(seen.corners[0], pixels), onPicture(seen.corners[i - 1], pixels),
         onPicture(seen.corners[i], pixels)},
        surfaceOf(triangle, strips)};
    turn = windingOf(piece);
    if (winding != 0 && turn != winding) return 0;
    triangles.push_back(piece);
  }
  return turn;
}

}  // namespace rotatebook::render
