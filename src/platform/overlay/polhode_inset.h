// The motion of the angular momentum in the body. Inside the room only.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "overlay/drawn_overlay.h"
#include "physics/inertia.h"

namespace rotatebook::overlay {

/// What the angular momentum, along the principal axes and in units of its size at the start, can
/// be: it is on a sphere, of radius 1, if it is conserved, and on an ellipsoid if the energy is.
class MomentumSurfaces {
 public:
  /// `momentum` is that of the start, along the principal axes. [kg m^2/s]
  MomentumSurfaces(const Eigen::Vector3d& moments, const Eigen::Vector3d& momentum);

  /// The ellipsoid's half axes.
  const Eigen::Vector3d& halfAxes() const { return halfAxes_; }
  /// The largest distance from the middle of a point of either surface.
  double farthest() const;
  /// The curve in which the ellipsoid meets the sphere of `radius`, closed: the branch on the
  /// positive or negative side of the axis that it runs round. Empty if they don't meet in a curve.
  std::vector<Eigen::Vector3d> polhode(double radius, bool positive) const;
  /// The axis that the curve of `radius` runs round.
  int roundAxis(double radius) const;

 private:
  Eigen::Vector3d halfAxes_;
};

/// An inset with both surfaces, their curves, and the angular momentum of the motion moving among
/// them.
class PolhodeInset final : public DrawnOverlay {
 public:
  PolhodeInset(const OverlayContext& context, const Box& box);
  void draw(const View& view) override;

 private:
  CachedLayer stillPart(const Box& box) const;

  OverlayContext context_;
  physics::PrincipalAxes inertia_;
  std::vector<Eigen::Vector3d> momenta_;  // of each sample, principal axes, that of the start is 1
  MomentumSurfaces surfaces_;
  Point middle_;
  double pixels_;  // of the length 1
  CachedLayer cached_;
};

}  // namespace rotatebook::overlay
