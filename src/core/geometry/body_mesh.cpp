#include "geometry/body_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/disjoint_sets.h"
#include "base/elementary.h"

namespace rotatebook::geometry {
namespace {

using Eigen::Vector3d;

/// A side of a triangle, from corner to corner.
struct Side {
  std::uint32_t low, high;  ///< Its points.
  std::uint32_t from, to;   ///< Its corners, 3 for each triangle.
  std::uint32_t triangle() const { return from / 3; }
};

/// Finds what is smooth on a surface, and makes the mesh's vertices.
class MeshMaker {
 public:
  MeshMaker(const body::Surface& surface, const Vector3d& size)
      : surface_(surface), size_(size), corners_(3 * surface.mesh.triangles.size()) {
    findNormals();
    findSides();
    joinSmooth();
  }

  const std::vector<std::array<std::uint32_t, 3>>& triangles() const {
    return surface_.mesh.triangles;
  }

  Mesh make() {
    Mesh mesh;
    const std::vector<body::Material>& materials = surface_.materials;
    mesh.parts.resize(materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i) {
      const auto alike = std::ranges::find(materials, materials[i]);
      mesh.parts[i].alike = static_cast<std::size_t>(alike - materials.begin());
    }
    addVertices(mesh);
    for (std::uint32_t i = 0; i < triangles().size(); ++i) {
      MeshPart& part = mesh.parts[materialOf(i)];
      for (std::uint32_t k = 0; k < 3; ++k) part.triangles.push_back(vertexOf_[3 * i + k]);
      part.stripOf.push_back(kNoStrip);
    }
    return mesh;
  }

 private:
  std::uint32_t pointOf(std::uint32_t corner) const { return triangles()[corner / 3][corner % 3]; }
  std::uint32_t materialOf(std::uint32_t triangle) const {
    return surface_.materialOf.empty() ? 0 : surface_.materialOf[triangle];
  }

  /// Computes twice the triangles' vector areas.
  void findNormals() {
    const auto& points = surface_.mesh.points;
    for (const auto& [a, b, c] : triangles())
      areas_.push_back((points[b] - points[a]).cross(points[c] - points[a]));
  }

  /// Sorts the sides, so that those of one edge are next to each other.
  void findSides() {
    for (std::uint32_t i = 0; i < triangles().size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = 3 * i + k, to = 3 * i + (k + 1) % 3;
        const auto [low, high] = std::minmax({pointOf(from), pointOf(to)});
        sides_.push_back({low, high, from, to});
      }
    }
    std::ranges::stable_sort(sides_, {},
                             [](const Side& side) { return std::pair(side.low, side.high); });
  }

  /// Calls each(side, other) for the pairs of sides that make an edge of two triangles.
  template <typename Each>
  void forEdges(const Each& each) const {
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      const Side &a = sides_[i], &b = sides_[i + 1];
      if (a.low == b.low && a.high == b.high) each(a, b);
    }
  }

  bool isSmooth(const Side& a, const Side& b) const {
    if (materialOf(a.triangle()) != materialOf(b.triangle())) return false;
    static const double kCosine = cosine(kCreaseDeg * kPi.high / 180);
    const Vector3d &first = areas_[a.triangle()], &second = areas_[b.triangle()];
    return first.dot(second) >= kCosine * first.norm() * second.norm();
  }

  /// Joins the corners at each point across smooth edges, and the triangles.
  void joinSmooth() {
    patches_ = DisjointSets(triangles().size());
    forEdges([this](const Side& a, const Side& b) {
      if (!isSmooth(a, b)) return;
      const bool isOpposite = pointOf(a.from) == pointOf(b.to);
      corners_.join(a.from, isOpposite ? b.to : b.from);
      corners_.join(a.to, isOpposite ? b.from : b.to);
      patches_.join(a.triangle(), b.triangle());
    });
  }

  /// Colours the patches, so that neighbours differ where kColours suffice, and different materials
  /// most often, also where their triangles don't share an edge.
  std::vector<int> patchColours() {
    std::vector<std::vector<std::uint32_t>> neighbours(triangles().size());
    forEdges([&](const Side& a, const Side& b) {
      const std::uint32_t first = patches_.of(a.triangle()), second = patches_.of(b.triangle());
      if (first == second) return;
      neighbours[std::max(first, second)].push_back(std::min(first, second));
    });
    std::vector<int> colours(triangles().size(), 0);
    for (std::size_t i = 0; i < colours.size(); ++i) {
      std::array<bool, kColours> taken{};
      for (const std::uint32_t other : neighbours[i])
        taken[static_cast<std::size_t>(colours[other])] = true;
      // If all are taken, any will do: an edge that isn't antialiased
      std::size_t colour = kColours / 3 * materialOf(static_cast<std::uint32_t>(i)) % kColours;
      for (int tries = 0; tries < kColours && taken[colour]; ++tries)
        colour = (colour + 1) % kColours;
      colours[i] = static_cast<int>(colour);
    }
    return colours;
  }

  /// Numbers a part of space around a position in the unit cube, 0 to below kCells: a surface that
  /// hides a part of itself is most often in another one there.
  static int cellOf(const Vector3d& unit) {
    int cell = 0;
    for (int axis = 0; axis < 3; ++axis)
      cell = 3 * cell + std::clamp(static_cast<int>(3 * unit[axis]), 0, 2);
    return cell;
  }

  void addVertices(Mesh& mesh) {
    std::vector<Vector3d> normals(3 * triangles().size(), Vector3d::Zero());
    for (std::uint32_t i = 0; i < normals.size(); ++i) normals[corners_.of(i)] += areas_[i / 3];
    const std::vector<int> colours = patchColours();
    // Corners of one smooth part share a vertex where they have the same texture coordinates
    std::vector<std::vector<std::uint32_t>> verticesOf(normals.size());
    for (std::uint32_t i = 0; i < normals.size(); ++i) {
      const std::uint32_t corner = corners_.of(i);
      const Vector3d unit =
          surface_.mesh.points[pointOf(i)].cwiseQuotient(size_) + Vector3d::Constant(0.5);
      const int colour = colours[patches_.of(i / 3)];
      const MeshVertex vertex{unit.cast<float>(),
                              covectorOf(normals[corner]),
                              texCoordOf(i),
                              1,
                              static_cast<float>(1 + kColours * cellOf(unit) + colour),
                              Eigen::Vector3f::Zero()};
      std::vector<std::uint32_t>& known = verticesOf[corner];
      const auto same = std::ranges::find_if(known, [&](std::uint32_t index) {
        return mesh.vertices[index].texCoord == vertex.texCoord;
      });
      if (same == known.end()) {
        known.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(vertex);
        vertexOf_.push_back(known.back());
      } else {
        vertexOf_.push_back(*same);
      }
    }
  }

  Eigen::Vector3f covectorOf(const Vector3d& normal) const {
    const Vector3d covector = normal.cwiseProduct(size_);
    const double length = covector.norm();
    return length > 0 ? Eigen::Vector3f((covector / length).cast<float>())
                      : Eigen::Vector3f::UnitZ();
  }

  Eigen::Vector2f texCoordOf(std::uint32_t corner) const {
    if (surface_.texCoords.empty()) return {0, 0};
    const Eigen::Vector2f& down = surface_.texCoords[corner / 3][corner % 3];
    return {down.x(), 1 - down.y()};
  }

  static constexpr int kColours = 9, kCells = 27;
  static_assert(kColours * kCells <= kMaxSurfaceId);

  const body::Surface& surface_;
  Vector3d size_;
  std::vector<Vector3d> areas_;  // By triangle. [m^2]
  std::vector<Side> sides_;
  DisjointSets corners_;                 // Those of a set share their normal.
  DisjointSets patches_{0};              // Triangles.
  std::vector<std::uint32_t> vertexOf_;  // By corner.
};

}  // namespace

Mesh makeBodyMesh(const body::Surface& surface, const Vector3d& size) {
  return MeshMaker(surface, size).make();
}

}  // namespace rotatebook::geometry
