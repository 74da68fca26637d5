// The classical Runge-Kutta method for a rigid body. Inside the room only.
#pragma once

#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/rigid_state.h"
#include "physics/steps/runge_kutta_step.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {

/// Returns state + factor * rate, component by component.
inline RigidState<Eigen::Matrix3d> addScaled(const RigidState<Eigen::Matrix3d>& state,
                                             double factor,
                                             const RigidState<Eigen::Matrix3d>& rate) {
  return {state.attitude + factor * rate.attitude, state.momentum + factor * rate.momentum};
}
inline RigidState<Eigen::Quaterniond> addScaled(const RigidState<Eigen::Quaterniond>& state,
                                                double factor,
                                                const RigidState<Eigen::Quaterniond>& rate) {
  return {Eigen::Quaterniond(state.attitude.coeffs() + factor * rate.attitude.coeffs()),
          state.momentum + factor * rate.momentum};
}

/// Returns the rate of an attitude that turns at `w`, along the body's axes: R [w]x or q (0, w)
/// / 2.
inline Eigen::Matrix3d rateOf(const Eigen::Matrix3d& attitude, const Eigen::Vector3d& w) {
  return attitude * rigid::crossMatrix(w);
}
inline Eigen::Quaterniond rateOf(const Eigen::Quaterniond& attitude, const Eigen::Vector3d& w) {
  return attitude * Eigen::Quaterniond(0, w.x() / 2, w.y() / 2, w.z() / 2);
}

/// Runge and Kutta's classical method on attitude and body momentum together: M' = M x w with
/// w = turnRate(M), and q' = q (0, w) / 2 or R' = R [w]x. Order 4; keeps nothing exactly; four
/// evaluations per step. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
/// I, table II.1.2.
class RungeKutta4 {
 public:
  static constexpr bool kMomentumInBody = true;
  static constexpr bool kTakesDissipation = true;

  RungeKutta4(const RigidConstants& body, double h) : body_(body), step_(stepOf(body, h)) {}

  /// Returns the step of a quaternion, of length h [s].
  static RungeKutta4Step<double> stepOf(const RigidConstants& body, double h) {
    return {toNumbers(body.inverseInertia), h};
  }

  void step(RigidState<Eigen::Matrix3d>& state) const { stepAsRate(state); }

  void step(RigidState<Eigen::Quaterniond>& state) const {
    if (body_.dissipation == 0) return takeStep(state, step_);
    stepAsRate(state);
  }

 private:
  template <typename Attitude>
  void stepAsRate(RigidState<Attitude>& state) const {
    state = afterRungeKutta4(state, step_.h, [&](const RigidState<Attitude>& at) {
      const Eigen::Vector3d w = turnRate(body_, at.momentum);
      return RigidState<Attitude>{rateOf(at.attitude, w), at.momentum.cross(w)};
    });
  }

  RigidConstants body_;
  RungeKutta4Step<double> step_;
};

}  // namespace rotatebook::physics
