// From the states of a simulator to the samples of a trajectory.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/exact/exact_rotation.h"
#include "physics/inertia.h"
#include "physics/motion_settings.h"
#include "physics/sample.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Bounds of the singular values of BodyState::worldFromBody within which a body still has the
/// shape that half-turns are counted of: nowhere squeezed to less than half its size, nor stretched
/// to more than twice. A rigid model's matrix is no longer anything like a rotation beyond,
/// particles have passed through each other, and the tilt turns over at random.
///
/// Measured in the scenes that ship: the half-turns of all that hold together come within 0.579 to
/// 1.481. The last that still follows from the ones before comes at 1.849 (fig11), the first of a
/// burst's at 2.292 (fig10: five within 0.8 s, after none in 15 s); of the particles of fig08 the
/// last at 1.049, the first of ninety at 1.482, after a stretch of 0.020.
inline constexpr double kMinStretch = 0.5, kMaxStretch = 2;

/// Whether a body of these singular values, smallest and largest, is within those bounds.
bool keepsItsShape(double stretchMin, double stretchMax);

/// Counts how often the tilt goes from under 60 to over 120 degrees or back. The wide gap keeps a
/// wobble about 90 degrees from counting.
class HalfTurnCounter {
 public:
  /// Takes the next tilt [degrees]; returns the count so far.
  int count(double tiltDeg);
  /// Keeps the count as it is from now on, whatever comes.
  void stop() { stopped_ = true; }

 private:
  enum class Side { None, Near, Far };

  Side side_ = Side::None;
  int halfTurns_ = 0;
  bool stopped_ = false;
};

/// Measures the states of one motion, in their order: the attitude's sign and the half-turns depend
/// on what came before. Once a state no longer keepsItsShape() the count of half-turns stays as it
/// was for good.
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

  Cuboid body_;
  int spunAxis_;
  PrincipalAxes inertia_;
  ExactRotation exact_;
  bool isExact_;  // whether it is also what is measured
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();  // the last one
  HalfTurnCounter counter_;
};

}  // namespace rotatebook::physics
