// Measurement of a simulator's states, which makes the samples of a trajectory.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "physics/sample.h"
#include "physics/simulator.h"
#include "rigid/exact_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Bounds on the singular values of BodyState::worldFromBody within which the half-turns of a body
/// are counted: it is nowhere squeezed to less than half its size, nor stretched to more than
/// twice. Beyond them a rigid model's matrix is nothing like a rotation, particles have passed
/// through each other, and the tilt flips at random.
///
/// Measured in the scenes that ship: bodies that hold together make all their half-turns within
/// 0.579 to 1.481. The last half-turn that still follows from those before comes at 1.849 (fig11),
/// the first of a random burst at 2.292 (fig10: five within 0.8 s, after none in 15 s). The
/// particles of fig08 make their last regular one at 1.049 and the first of ninety random ones at
/// 1.482, after a stretch of 0.020.
inline constexpr double kMinStretch = 0.5, kMaxStretch = 2;

/// Returns whether these singular values, smallest and largest, are within those bounds.
bool keepsItsShape(double stretchMin, double stretchMax);

/// Returns the principal axis nearest to the axis of the spin, a unit vector in body axes. Of its
/// two directions it is the one along the edge of the body that it is nearest to.
Eigen::Vector3d spunAxisOf(const MotionSettings& settings, const rigid::PrincipalAxes& inertia);

/// Returns the angle between the spun body axis, turned by `rotation`, and the momentum. [degrees]
double tiltDegOf(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& spunAxis,
                 const Eigen::Vector3d& momentum);

/// Tilts between which a half-turn is being made. [degrees]
inline constexpr double kNearTiltDeg = 60, kFarTiltDeg = 120;

/// Sides of the tilt between which half-turns are counted: under kNearTiltDeg, over kFarTiltDeg.
enum class TiltSide { None, Near, Far };
TiltSide sideOf(double tiltDeg);
/// Takes the cosine of the tilt times a length > 0, and that length.
TiltSide sideOfCosine(double along, double length);

/// Returns when the half-turn between two neighbouring samples was made: the tilt passed 120
/// degrees, or 60 on its way back. Interpolates linearly; returns the later sample's time if there
/// were several half-turns, or the tilts don't say. [s]
double halfTurnTime(const Sample& before, const Sample& sample);

/// Counts how often the tilt goes from under 60 to over 120 degrees or back. The wide gap keeps a
/// wobble about 90 degrees from counting.
class HalfTurnCounter {
 public:
  /// Takes the next tilt [degrees]; returns the count so far.
  int count(double tiltDeg);
  /// Takes likewise what sideOfCosine() takes.
  int countCosine(double along, double length);
  /// Freezes the count for good.
  void stop() { stopped_ = true; }

 private:
  int countSide(TiltSide side);

  TiltSide side_ = TiltSide::None;
  int halfTurns_ = 0;
  bool stopped_ = false;
};

/// Presence in samples of errorDeg and regime, which cost as much as an exact motion.
enum class Compared { No, WithExact };

/// Measures the states of one motion, in their order: the sign of the attitude and the half-turns
/// depend on the states before. Once a state fails keepsItsShape(), the count of half-turns is
/// frozen.
class Measurement {
 public:
  /// Takes as the spun axis the principal axis along which the initial angular velocity has its
  /// largest component. Throws InputError as InitialSpin::tilted() does.
  explicit Measurement(const MotionSettings& settings, Compared compared = Compared::WithExact);

  /// Returns the sample at `time` [s] of `state`, whose numbers must be finite.
  Sample measure(double time, const BodyState& state);

 private:
  Eigen::Quaterniond continuedAttitude(const Eigen::Matrix3d& rotation);
  rigid::Regime regime(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& angularVelocity,
                       rigid::Regime exact) const;

  body::Cuboid body_;
  rigid::PrincipalAxes inertia_;
  Eigen::Vector3d spunAxis_;
  std::optional<NudgedRotation> exact_;  // unless there is no comparison
  bool isExact_;                         // whether the measured motion is itself exact
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();  // the last one
  HalfTurnCounter counter_;
};

}  // namespace rotatebook::physics
