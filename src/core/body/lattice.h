// Points of a lattice inside a body.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Points in rows along x, y and z.
struct Lattice {
  Eigen::Vector3d first{0, 0, 0};  ///< The point of the smallest coordinates.
  double cell = 1;                 ///< From a point to the next, > 0.
  std::array<int, 3> counts{};     ///< Of points along x, y and z, each > 0.

  std::size_t size() const {
    return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
           static_cast<std::size_t>(counts[2]);
  }
  Eigen::Vector3d point(int x, int y, int z) const {
    return first + cell * Eigen::Vector3d(x, y, z);
  }
  /// Returns the place of a point in lists of all of them: x is counted first, then y.
  std::size_t index(int x, int y, int z) const {
    const auto nx = static_cast<std::size_t>(counts[0]), ny = static_cast<std::size_t>(counts[1]);
    return (static_cast<std::size_t>(z) * ny + static_cast<std::size_t>(y)) * nx +
           static_cast<std::size_t>(x);
  }
};

/// Returns a lattice of `cells` along the longest side of a box, with a point in the middle of each
/// cell; along the other sides with as many as they need, in the middle of the box.
Lattice latticeIn(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int cells);

/// Returns how often a closed mesh winds around each point of a lattice: how many of its surfaces
/// enclose it. A point on the surface counts to one of its sides. Each row of points along x
/// crosses the triangles that its line goes through; a line through an edge or a corner goes
/// through exactly as many as one beside it, since the side of an edge is found alike for both of
/// its triangles (Sunday 2001).
std::vector<int> windingNumbers(const TriangleMesh& mesh, const Lattice& lattice);

}  // namespace rotatebook::body
