// The classical Runge-Kutta method for a rigid body. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Runge and Kutta's classical method on attitude and body momentum together: M' = M x w with
/// w = I^-1 M, and q' = q (0, w) / 2 or R' = R [w]x. Order 4; keeps nothing exactly; four
/// evaluations per step. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
/// I, table II.1.2.
class RungeKutta4 {
 public:
  static constexpr bool kMomentumInBody = true;

  RungeKutta4(const RigidConstants& body, double h) : body_(body), h_(h) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const auto k1 = rate(state);
    const auto k2 = rate(addScaled(state, h_ / 2, k1));
    const auto k3 = rate(addScaled(state, h_ / 2, k2));
    const auto k4 = rate(addScaled(state, h_, k3));
    state = addScaled(addScaled(state, h_ / 6, k1), h_ / 3, k2);
    state = addScaled(addScaled(state, h_ / 3, k3), h_ / 6, k4);
  }

 private:
  template <typename Attitude>
  RigidState<Attitude> rate(const RigidState<Attitude>& state) const {
    const Eigen::Vector3d w = body_.inverseInertia.cwiseProduct(state.momentum);
    return {rateInBody(state.attitude, w), state.momentum.cross(w)};
  }

  template <typename Attitude>
  static RigidState<Attitude> addScaled(const RigidState<Attitude>& state, double factor,
                                        const RigidState<Attitude>& rate) {
    return {physics::addScaled(state.attitude, factor, rate.attitude),
            state.momentum + factor * rate.momentum};
  }

  RigidConstants body_;
  double h_;
};

}  // namespace rotatebook::physics
