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

/// Runge and Kutta's classical method on attitude and body momentum together: M' = M x w with
/// w = I^-1 M, and q' = q (0, w) / 2 or R' = R [w]x. Order 4; keeps nothing exactly; four
/// evaluations per step. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
/// I, table II.1.2.
class RungeKutta4 {
 public:
  static constexpr bool kMomentumInBody = true;

  RungeKutta4(const RigidConstants& body, double h) : step_(stepOf(body, h)) {}

  /// Returns the step of a quaternion, of length h [s].
  static RungeKutta4Step<double> stepOf(const RigidConstants& body, double h) {
    return {toNumbers(body.inverseInertia), h};
  }

  void step(RigidState<Eigen::Matrix3d>& state) const {
    const Eigen::Vector3d inverseInertia = toEigen(step_.inverseInertia);
    state = afterRungeKutta4(state, step_.h, [&](const RigidState<Eigen::Matrix3d>& at) {
      const Eigen::Vector3d w = inverseInertia.cwiseProduct(at.momentum);
      return RigidState<Eigen::Matrix3d>{at.attitude * rigid::crossMatrix(w), at.momentum.cross(w)};
    });
  }

  void step(RigidState<Eigen::Quaterniond>& state) const { takeStep(state, step_); }

 private:
  RungeKutta4Step<double> step_;
};

}  // namespace rotatebook::physics
