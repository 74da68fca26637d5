// The numbers of a spin: of the free rigid body's motion that starts with it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "rigid/regime.h"

namespace rotatebook::timeline {

/// Principal moments that are equal, of I1 <= I2 <= I3.
enum class EqualMoments { None, TwoSmallest, TwoLargest, All };

/// The period in which the angular velocity of a tumbling body comes back, seen from the body.
/// After it the body is as at its start, but for a turn about the angular momentum L.
struct SpinPeriod {
  double time = 0;  ///< T, > 0. [s]
  /// Turn about L in that time, whole turns counted: as a steady spin's, which is |w| T. [rad]
  double turn = 0;
  /// 2 E T / |L|, the part of the turn that the energy gives. [rad]
  double dynamicTurn = 0;
  /// The rest, its geometric part: the solid angle that L encloses on the body's sphere about the
  /// axis that it circles, below 2 pi; negative about the largest moment's, positive about the
  /// smallest moment's, as L goes the other way round. (Montgomery 1991) [rad]
  double geometricTurn = 0;
  /// Turn about L of the axis that L circles: the precession of a symmetric top's axis. [rad]
  double axisTurn = 0;
};

/// The rigid body and its spin at t = 0, and what follows from them. Vectors are in body axes;
/// I1 <= I2 <= I3 are the principal moments, and W is the length of the angular velocity.
struct Spin {
  std::array<double, 3> moments{};        ///< I1, I2, I3. [kg m^2]
  std::array<Eigen::Vector3d, 3> axes{};  ///< Unit vectors along their principal axes.
  EqualMoments equal = EqualMoments::None;
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< [kg m^2/s]
  double energy = 0;                         ///< E. [J]
  std::size_t spunAxis = 0;  ///< Index of the principal axis along which most of the spin is.
  double offAxis = 0;        ///< Angle of the angular velocity to that axis. [rad]
  bool isSteady = false;     ///< Exactly about a principal axis: the angular velocity stays.
  rigid::Regime regime = rigid::Regime::Separatrix;
  /// lambda = W sqrt((I2 - I1)(I3 - I2)/(I1 I3)), with which small deviations from a spin about the
  /// middle axis grow as e^(lambda t); only if that is the spun axis. [1/s]
  std::optional<double> growth{};
  /// Rate at which small deviations from a spin about another axis circle it; only if that is the
  /// spun axis: W sqrt((I2 - I1)(I3 - I1)/(I2 I3)) and W sqrt((I3 - I1)(I3 - I2)/(I1 I2)). [rad/s]
  std::optional<double> oscillation{};
  std::optional<SpinPeriod> period{};  ///< None on the separatrix and of a steady spin.
  /// L^2 / (2 E I2) - 1: 0 on the separatrix, positive where L circles the axis of I3, negative
  /// where it circles that of I1. None if moments are equal, when there is no separatrix.
  std::optional<double> margin{};
  /// Angle from the angular velocity to the nearest one on the separatrix; with margin. [rad]
  std::optional<double> toSeparatrix{};

  /// Time at which the spun axis has turned over first, as half-turns are counted: its angle to L
  /// passes 120 degrees. None if L circles that axis, if moments are equal, or if it never comes so
  /// far, as where the spin is nearly as fast about another axis. [s]
  std::optional<double> firstFlip{};

  /// Returns the number of the axis that L circles.
  std::size_t circledAxis() const { return regime == rigid::Regime::AboutLargest ? 2 : 0; }
  /// Returns the time between flips, half the period, of a body that flips: with firstFlip. [s]
  std::optional<double> flipInterval() const;
};

/// Returns the numbers of the spin in `settings`; of particles, those of a rigid body with their
/// moments. Throws InputError as InitialSpin::tilted() does.
Spin spinOf(const physics::MotionSettings& settings);

}  // namespace rotatebook::timeline
