// Draws the path of the angular momentum in the body. Inside the room only.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace rotatebook::overlay {

/// The surfaces of possible angular momenta, along the principal axes and in units of the initial
/// one's norm: a sphere of radius 1 if it is conserved, and an ellipsoid if the energy is.
class MomentumSurfaces {
 public:
  /// Takes the principal moments and the initial `momentum` along the principal axes. [kg m^2/s]
  MomentumSurfaces(const Eigen::Vector3d& moments, const Eigen::Vector3d& momentum);

  /// Returns the ellipsoid's half axes.
  const Eigen::Vector3d& halfAxes() const { return halfAxes_; }
  /// Returns the largest distance of a point of either surface from the centre.
  double farthest() const;
  /// Returns the closed curve in which the ellipsoid intersects the sphere of `radius`: the branch
  /// on the positive or negative side of the axis that it runs around. Empty if there is no curve.
  std::vector<Eigen::Vector3d> polhode(double radius, bool positive) const;
  /// Returns the axis that the curve of `radius` runs around.
  int roundAxis(double radius) const;

 private:
  Eigen::Vector3d halfAxes_;
};

}  // namespace rotatebook::overlay
