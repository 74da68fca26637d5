// Draws the body's axes, the angular velocity and the angular momentum. Inside the room only.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "overlay/box.h"
#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// The body's axes, from its centre out through its faces.
class Axes final : public DrawnOverlay {
 public:
  explicit Axes(const OverlayContext& context);
  void draw(const View& view) override;
  std::vector<Arrow> arrows(const physics::Sample& sample) const override;

 private:
  OverlayContext context_;
  std::array<Layer, 3> letters_;
};

/// Lengths of arrows in the world. They are limited where a motion grows without limit.
class ArrowScale {
 public:
  explicit ArrowScale(const OverlayContext& context);
  /// Returns the tip of the arrow for an angular velocity [rad/s]. [m]
  Eigen::Vector3d omegaTip(const Eigen::Vector3d& angularVelocity) const;
  /// Returns the tip of the arrow for an angular momentum [kg m^2/s]. [m]
  Eigen::Vector3d momentumTip(const Eigen::Vector3d& angularMomentum) const;

 private:
  double reach_;     // of the body from its centre [m]
  double velocity_;  // has the full length [rad/s]
  double momentum_;  // has the full length [kg m^2/s]
};

/// Makes the angular velocity's arrow from the body's centre.
std::unique_ptr<DrawnOverlay> makeOmega(const OverlayContext& context, const Box&);
/// Makes the angular momentum's arrow from the body's centre.
std::unique_ptr<DrawnOverlay> makeMomentum(const OverlayContext& context, const Box&);

/// The path of the angular velocity's tip during the last seconds, in the camera's frame of
/// reference.
class Trail final : public DrawnOverlay {
 public:
  explicit Trail(const OverlayContext& context);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  std::vector<Eigen::Vector3d> tips_;  // of each sample
  std::int64_t length_;                // in samples
};

}  // namespace rotatebook::overlay
