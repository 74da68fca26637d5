// The exact motion of a free rigid body.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "base/double_double.h"
#include "base/elliptic.h"
#include "base/layout.h"
#include "rigid/polhode.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {

/// Computes the torque-free motion in closed form: Jacobi functions for the angular velocity
/// (Landau and Lifshitz, Mechanics, section 37), an elliptic integral of the third kind for the
/// turn about the angular momentum (van Zon and Schofield 2007). Takes no steps and keeps no state.
/// Rates and periods are double-double numbers, so that the errors don't grow with time.
class ExactMotion {
 public:
  /// Takes principal moments in any order, each > 0 and none larger than the sum of the others,
  /// like those of every body [kg m^2], and the angular velocity at t = 0 along the principal axes,
  /// which may be zero [rad/s]. Both are taken as exact: near the separatrix, rounding them gives
  /// quite another motion.
  ExactMotion(const Eigen::Vector3d& inertia, const Eigen::Vector3d& angularVelocity);
  /// Both numbers in double-double precision, as a rotated tensor gives them.
  struct Start {
    DoubleDouble3 inertia, angularVelocity;
  };
  explicit ExactMotion(const Start& start);

  /// The body at one time.
  struct Moment {
    Eigen::Vector3d angularVelocityBody{0, 0, 0};  ///< To 1e-13 of its initial value. [rad/s]
    /// Attitude, to 1e-13, and orthogonal to 1e-14. World axes are the body's at t = 0.
    Eigen::Matrix3d worldFromBody = Eigen::Matrix3d::Identity();
  };
  /// Returns the body at any time, even a negative one. [s]
  Moment at(double time) const;
  /// Returns the angular velocity of at() alone, without the integral of the third kind. [rad/s]
  Eigen::Vector3d angularVelocityBodyAt(double time) const;

  Regime regime() const { return regime_; }
  /// Returns the time between sign changes of the angular velocity about the middle axis: half its
  /// period. Infinite if there is no period: on the separatrix and in a steady spin. [s]
  double flipInterval() const;

 private:
  Moment steadyAt(double time) const;
  Moment polhodeAt(double time) const;

  // A place on the polhode, which is within K of a zero of sn.
  struct Place {
    double halves;  // half-periods left out
    double u;
    JacobiValues values;  // at u
    Eigen::Vector3d angularVelocity;
  };
  Place placeAt(double time) const;
  Eigen::Matrix3d bodyFromMomentum(const Eigen::Vector3d& angularVelocity) const;

  Eigen::Vector3d inertia_;
  Eigen::Vector3d start_;           // angular velocity at t = 0
  DoubleDouble speed_;              // its norm
  std::optional<Polhode> polhode_;  // none if the spin is steady
  Regime regime_;
  JacobiFunctions jacobi_;
  EllipticPi ellipticPi_;
  double startTurn_ = 0;  // weight P(start) of the polhode
  Eigen::Matrix3d worldFromMomentum_ = Eigen::Matrix3d::Identity();  // at t = 0
};

}  // namespace rotatebook::rigid
