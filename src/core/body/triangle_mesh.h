// The surface of a body as triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::body {

/// The most triangles that a mesh may have.
inline constexpr std::size_t kMaxTriangles = 4'000'000;

/// Triangles over shared points.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;  ///< [the mesh's unit of length]
  /// Indices of three points each, counter-clockwise from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Returns the mesh with every position once: points of equal coordinates become one, without any
/// tolerance, and 0 and -0 are equal. Points that no triangle uses are left out. Throws InputError
/// if a triangle names a point that doesn't exist, or a coordinate that is used isn't finite.
TriangleMesh welded(const TriangleMesh& mesh);

/// A box along the axes.
struct Box {
  Eigen::Vector3d low, high;
};

/// Returns the box around points, of which there is one or more.
Box boxAround(std::span<const Eigen::Vector3d> points);

/// Adds the points and triangles of another mesh.
void append(const TriangleMesh& added, TriangleMesh& into);

}  // namespace rotatebook::body
