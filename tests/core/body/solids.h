// Meshes of known bodies, for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "body/triangle_mesh.h"

namespace rotatebook::body::testing {

/// Returns a box about the origin, 12 triangles.
inline TriangleMesh boxMesh(double x, double y, double z) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back((i & 1) != 0 ? x / 2 : -x / 2, (i & 2) != 0 ? y / 2 : -y / 2,
                             (i & 4) != 0 ? z / 2 : -z / 2);
  }
  constexpr std::uint32_t kQuads[][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& [a, b, c, d] : kQuads) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

/// Returns a tetrahedron between the origin and the three axes' units.
inline TriangleMesh tetrahedronMesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Returns a prism about z over a regular polygon.
inline TriangleMesh prismMesh(std::uint32_t sides, double radius, double height) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {-height / 2, height / 2})
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t low = 2 * i, next = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({low, next, next + 1});
    mesh.triangles.push_back({low, next + 1, low + 1});
    if (i == 0 || i + 1 == sides) continue;
    mesh.triangles.push_back({0, next, low});
    mesh.triangles.push_back({1, low + 1, next + 1});
  }
  return mesh;
}

/// Returns a sphere of circles around z, 2 rings (rings - 1) triangles for each of `sides`.
inline TriangleMesh ballMesh(std::uint32_t rings, std::uint32_t sides) {
  TriangleMesh mesh;
  for (std::uint32_t i = 1; i < rings; ++i) {
    const double theta = std::numbers::pi * i / rings;
    for (std::uint32_t j = 0; j < sides; ++j) {
      const double phi = 2 * std::numbers::pi * j / sides;
      mesh.points.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0, 0, 1);
  mesh.points.emplace_back(0, 0, -1);
  for (std::uint32_t j = 0; j < sides; ++j) {
    const std::uint32_t k = (j + 1) % sides, last = (rings - 2) * sides;
    mesh.triangles.push_back({top, j, k});
    mesh.triangles.push_back({top + 1, last + k, last + j});
    for (std::uint32_t i = 0; i + 2 < rings; ++i) {
      mesh.triangles.push_back({i * sides + j, (i + 1) * sides + j, (i + 1) * sides + k});
      mesh.triangles.push_back({i * sides + j, (i + 1) * sides + k, i * sides + k});
    }
  }
  return mesh;
}

}  // namespace rotatebook::body::testing
