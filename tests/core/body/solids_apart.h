// Meshes of several bodies, and of triangles that share no points, for tests.
#pragma once

#include <cstdint>
#include <random>

#include "body/solids.h"
#include "body/triangle_mesh.h"

namespace rotatebook::body::testing {

/// Returns a mesh moved by `place`.
inline TriangleMesh movedTo(TriangleMesh mesh, const Eigen::Vector3d& place) {
  for (Eigen::Vector3d& point : mesh.points) point += place;
  return mesh;
}

/// Returns both meshes as one, the second moved by `place`; their points aren't shared.
inline TriangleMesh together(TriangleMesh one, const TriangleMesh& other,
                             const Eigen::Vector3d& place) {
  append(movedTo(other, place), one);
  return one;
}

/// Returns the mesh inside out.
inline TriangleMesh insideOut(TriangleMesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

/// Returns the mesh with three points of its own for each triangle, each coordinate moved by up to
/// `noise`, as programs write that round corners triangle by triangle.
inline TriangleMesh soupOf(const TriangleMesh& mesh, double noise) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-noise, noise);
  TriangleMesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t point : triangle) {
      const Eigen::Vector3d moved(shift(random), shift(random), shift(random));
      soup.points.push_back(mesh.points[point] + moved);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

}  // namespace rotatebook::body::testing
