// The motion of a free rigid body, exactly.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "base/double_double.h"
#include "physics/exact/elliptic.h"
#include "physics/exact/polhode.h"
#include "physics/measure/regime.h"

namespace rotatebook::physics {

/// The torque-free motion in closed form: Jacobi functions for the angular velocity (Landau and
/// Lifshitz, Mechanics, section 37), an elliptic integral of the third kind for the turn about the
/// angular momentum (van Zon and Schofield 2007). Nothing is stepped or kept. Rates and periods
/// have twice a double's precision, so that the errors don't grow with time.
class ExactMotion {
 public:
  /// Principal moments in any order, each > 0 and none larger than the sum of the others, as those
  /// of every body are [kg m^2]; the angular velocity at t = 0 along the principal axes, which may
  /// be zero [rad/s]. Both are taken as they are: near the separatrix a rounding of them makes
  /// quite another motion.
  ExactMotion(const Eigen::Vector3d& inertia, const Eigen::Vector3d& angularVelocity);
  /// The same of numbers of twice the precision, as those of a turned tensor.
  struct Start {
    DoubleDouble3 inertia, angularVelocity;
  };
  explicit ExactMotion(const Start& start);

  /// The body at one time.
  struct Moment {
    Eigen::Vector3d angularVelocityBody{0, 0, 0};  ///< To 1e-13 of its start. [rad/s]
    /// Attitude, to 1e-13, and orthogonal to 1e-14. The world's axes are the body's at t = 0.
    Eigen::Matrix3d worldFromBody = Eigen::Matrix3d::Identity();
  };
  /// The body at any time, also a negative one. [s]
  Moment at(double time) const;

  Regime regime() const { return regime_; }
  /// Time between changes of sign of the angular velocity about the median axis: half its period.
  /// Infinite where there is no period: on the separatrix and in a steady spin. [s]
  double flipInterval() const;

 private:
  Moment steadyAt(double time) const;
  Moment polhodeAt(double time) const;
  Eigen::Matrix3d bodyFromMomentum(const Eigen::Vector3d& angularVelocity) const;

  Eigen::Vector3d inertia_;
  Eigen::Vector3d start_;  // angular velocity at t = 0
  DoubleDouble speed_;     // its norm
  Regime regime_;
  std::optional<Polhode> polhode_;  // none if the spin is steady
  JacobiFunctions jacobi_;
  EllipticPi thirdKind_;
  double startTurn_ = 0;  // weight P(start) of the polhode
  Eigen::Matrix3d worldFromMomentum_ = Eigen::Matrix3d::Identity();  // at t = 0
};

}  // namespace rotatebook::physics
