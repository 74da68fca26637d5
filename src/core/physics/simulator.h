// The one interface behind which all models stand.
#pragma once

#include <Eigen/Core>

#include "physics/cuboid.h"

namespace rotatebook::physics {

/// What every model can tell of its body at one moment; world axes, SI units.
struct BodyState {
  Corners corners = Corners::Zero();  ///< The corners as they are drawn, deformed or not. [m]
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< About the centre of mass. [kg m^2/s]
  double kinetic = 0;                        ///< [J]
  double potential = 0;                      ///< In the springs; 0 for a rigid body. [J]
  double rotational = 0;  ///< Kinetic energy of the best-fitting rigid motion, w.L/2. [J]
};

/// A body in motion. Starts at t = 0 with body and world axes equal.
class Simulator {
 public:
  virtual ~Simulator() = default;

  /// `steps` integration steps of length `h` > 0. [s] Throws NoConvergence.
  virtual void advance(double h, int steps) = 0;
  /// The present state. Once a motion has blown up its numbers need not be finite.
  virtual BodyState state() const = 0;
};

}  // namespace rotatebook::physics
