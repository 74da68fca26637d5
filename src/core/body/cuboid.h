// The body: a homogeneous cuboid, the book.
#pragma once

#include <Eigen/Core>

#include "base/layout.h"

namespace rotatebook::body {

/// The eight corners of a body, deformed or not, one per column. [m] Corner i has the sign of x
/// from bit 0 of i, of y from bit 1, of z from bit 2.
using Cage = Eigen::Matrix<double, 3, 8>;

/// A cuboid with its centre of mass at the origin and its edges along its principal axes: x through
/// the spine's midpoint, y through the top, z through the cover.
struct Cuboid {
  Eigen::Vector3d size{0.1878, 0.29085, 0.05};  ///< Edge lengths along x, y, z, each > 0. [m]
  double mass = 1.0;                            ///< > 0. [kg]

  /// Returns the eight corners in body axes. [m]
  Cage corners() const;
  /// Returns the principal moments of the solid body, M/12 (b^2+c^2, a^2+c^2, a^2+b^2). [kg m^2]
  Eigen::Vector3d solidInertia() const;
  /// Returns the principal moments of eight particles of mass M/8 at the corners: three times
  /// solidInertia(). [kg m^2]
  Eigen::Vector3d particleInertia() const;
  /// Returns the longest edge. [m]
  double largestDimension() const { return size.maxCoeff(); }

  friend bool operator==(const Cuboid&, const Cuboid&) = default;
};

}  // namespace rotatebook::body
