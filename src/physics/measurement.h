// From the states of a simulator to the samples of a trajectory.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/exact_rotation.h"
#include "physics/inertia.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Counts how often the tilt goes from under 60 to over 120 degrees or back. The wide gap keeps a
/// wobble about 90 degrees from counting.
class HalfTurnCounter {
 public:
  /// Takes the next tilt [degrees]; returns the count so far.
  int count(double tiltDeg);

 private:
  enum class Side { None, Near, Far };

  Side side_ = Side::None;
  int halfTurns_ = 0;
};

/// Measures the states of one motion, in their order: the attitude's sign and the half-turns depend
/// on what came before.
class Measurement {
 public:
  /// The spun body axis is that of the initial angular velocity's largest component. Throws
  /// InputError as InitialSpin::tilted() does.
  explicit Measurement(const MotionSettings& settings);

  /// The sample at `time` [s] of `state`, whose numbers are finite.
  Sample measure(double time, const BodyState& state);

 private:
  Eigen::Quaterniond continuedAttitude(const Eigen::Matrix3d& rotation);
  double tiltDeg(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& momentum) const;
  Regime regime(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& angularVelocity) const;

  Eigen::Matrix<double, 8, 3> mapFromCorners_;  // C^T (C C^T)^-1 of the body's corners C
  int spunAxis_;
  PrincipalAxes inertia_;
  ExactRotation exact_;
  bool isExact_;  // whether it is also what is measured
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();  // the last one
  HalfTurnCounter counter_;
};

}  // namespace rotatebook::physics
