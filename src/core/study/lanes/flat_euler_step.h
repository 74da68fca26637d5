// Euler's step in lanes of a momentum in the plane of x and z. Inside the room only.
#pragma once

#include "physics/steps/euler_step.h"

namespace rotatebook::study::lanes {

/// EulerStep, bit by bit, where the momentum's part along y is 0, not -0, and the other two
/// aren't 0. What is multiplied by that part is left out: of 65 operations five. Zeros of the other
/// sign, which that gives, are added to what isn't 0, or to 0.
template <typename Number>
struct FlatEulerStep : physics::EulerStep<Number> {
  /// Returns turnedToBody() of the state.
  static physics::Vector3<Number> inBody(const physics::StepState<Number>& state) {
    const Number s = state.attitude.w;
    const physics::Vector3<Number> u = state.attitude.vec(), l = state.momentum;
    const Number x = Number(2) * l.x, z = Number(2) * l.z;
    const physics::Vector3<Number> t{u.y * z, u.z * x - u.x * z, u.y * (Number(0) - x)};
    const physics::Vector3<Number> rest{l.x - s * t.x, negativeProduct(s, t.y), l.z - s * t.z};
    return rest + cross(u, t);
  }

  void operator()(physics::StepState<Number>& state) const {
    this->turn(state.attitude, inBody(state));
  }
};

}  // namespace rotatebook::study::lanes
