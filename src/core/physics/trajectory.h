// A whole motion as a value.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/cuboid.h"
#include "physics/measure/regime.h"
#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// The body at one moment, measured; world axes, SI units unless said otherwise.
struct Sample {
  double time = 0;  ///< Simulated time. [s]
  /// World from body; polar rotation of the map that best fits the corners. w >= 0 at the start,
  /// then of continuous sign.
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< About the centre of mass. [kg m^2/s]
  double kinetic = 0;                        ///< [J]
  double potential = 0;                      ///< [J]
  double rotational = 0;  ///< Kinetic energy of the best-fitting rigid motion. [J]
  double tiltDeg = 0;     ///< Angle between the spun body axis and the angular momentum. [degrees]
  /// How often the tilt has gone from under 60 to over 120 degrees or back while the body was no
  /// farther deformed than isBook() allows. What comes after that isn't counted.
  int halfTurns = 0;
  double stretchMin = 1;  ///< Smallest singular value of the map that best fits the corners.
  double stretchMax = 1;  ///< Largest one.
  /// Angle of the rotation between the attitude and that of the exact rigid motion from the same
  /// start. [degrees]
  double errorDeg = 0;
  /// The rigid motion that this angular velocity, seen from this attitude, begins; of Model::Exact
  /// that of its start.
  Regime regime = Regime::Separatrix;
  Corners corners = Corners::Zero();  ///< As drawn. [m]

  double total() const { return kinetic + potential; }
};

/// A motion: one sample every `interval`, the first at t = 0.
struct Trajectory {
  double interval = 0;          ///< [s]
  std::vector<Sample> samples;  ///< Never empty.
  /// Time of the first sample that doesn't exist, because there a corner was farther from the
  /// origin than kDivergenceFactor times the body's largest dimension, or a number was not finite.
  /// [s]
  std::optional<double> divergedAt{};
};

/// See Trajectory::divergedAt.
inline constexpr double kDivergenceFactor = 20;

/// Simulates `sampleCount` >= 1 samples, fewer if the motion diverges. Throws InputError if the
/// initial spin can't be tilted as asked, or is so large that not even the first sample is finite;
/// NoConvergence if an implicit integrator finds no solution for its steps. `stop`, if not null and
/// set from outside, ends it after a sample: what is returned is then of no use.
Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop = nullptr);

}  // namespace rotatebook::physics
