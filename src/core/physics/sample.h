// A body at one moment, measured.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/cuboid.h"
#include "physics/measure/regime.h"

namespace rotatebook::physics {

/// The body at one moment, measured; world axes, SI units unless said otherwise.
struct Sample {
  double time = 0;  ///< Simulated time. [s]
  /// World from body; polar rotation of BodyState::worldFromBody. w >= 0 at the start, then of
  /// continuous sign.
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< About the centre of mass. [kg m^2/s]
  double kinetic = 0;                        ///< [J]
  double potential = 0;                      ///< [J]
  double rotational = 0;  ///< Kinetic energy of the best-fitting rigid motion. [J]
  double tiltDeg = 0;     ///< Angle between the spun body axis and the angular momentum. [degrees]
  /// How often the tilt has gone from under 60 to over 120 degrees or back while the body was no
  /// farther deformed than keepsItsShape() allows. What comes after that isn't counted.
  int halfTurns = 0;
  double stretchMin = 1;  ///< Smallest singular value of BodyState::worldFromBody.
  double stretchMax = 1;  ///< Largest one.
  /// Angle of the rotation between the attitude and that of the exact rigid motion from the same
  /// start. [degrees]
  double errorDeg = 0;
  /// The rigid motion that this angular velocity, seen from this attitude, begins; of Model::Exact
  /// that of its start.
  Regime regime = Regime::Separatrix;
  Cage cage = Cage::Zero();  ///< As drawn. [m]

  double total() const { return kinetic + potential; }
};

}  // namespace rotatebook::physics
