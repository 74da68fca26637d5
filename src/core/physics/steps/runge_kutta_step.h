// A step of the classical Runge-Kutta method.
#pragma once

#include "physics/steps/step_state.h"

namespace rotatebook::physics {

/// Returns the state after a step of length h, for any type of state that addScaled() takes: from
/// four evaluations of its rate.
template <typename State, typename Number, typename RateOf>
State afterRungeKutta4(const State& state, Number h, const RateOf& rateOf) {
  const State k1 = rateOf(state);
  const State k2 = rateOf(addScaled(state, h / Number(2), k1));
  const State k3 = rateOf(addScaled(state, h / Number(2), k2));
  const State k4 = rateOf(addScaled(state, h, k3));
  const State half = addScaled(addScaled(state, h / Number(6), k1), h / Number(3), k2);
  return addScaled(addScaled(half, h / Number(3), k3), h / Number(6), k4);
}

/// The step of RungeKutta4 for a quaternion.
template <typename Number>
struct RungeKutta4Step {
  using State = StepState<Number>;
  static constexpr bool kMomentumInBody = true;

  Vector3<Number> inverseInertia;  ///< [1/(kg m^2)]
  Number h;                        ///< [s]

  void operator()(StepState<Number>& state) const {
    const Moving after = afterRungeKutta4(Moving{state.attitude, state.momentum}, h,
                                          [this](const Moving& at) { return rateAt(at); });
    state.attitude = after.attitude;
    state.momentum = after.momentum;
  }

 private:
  // A state, or its rate.
  struct Moving {
    Quaternion<Number> attitude;
    Vector3<Number> momentum;

    friend Moving addScaled(const Moving& state, Number factor, const Moving& rate) {
      return {physics::addScaled(state.attitude, factor, rate.attitude),
              state.momentum + factor * rate.momentum};
    }
  };

  // q (0, w) / 2 and M x w
  Moving rateAt(const Moving& at) const {
    const Vector3<Number> w = componentProduct(inverseInertia, at.momentum);
    const Vector3<Number> half = w / Number(2);
    return {at.attitude * Quaternion<Number>{Number(0), half.x, half.y, half.z},
            cross(at.momentum, w)};
  }
};

}  // namespace rotatebook::physics
