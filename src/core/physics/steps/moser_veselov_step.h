// A step of the discrete Moser-Veselov algorithm.
#pragma once

#include "physics/steps/fixed_point.h"

namespace rotatebook::physics {

/// The equation of a step of MoserVeselov, c1 = share (1 + |c|^2) a1 + (J2 - J3)/J1 c2 c3 and
/// cyclic, where share 1 is the whole step.
template <typename Number>
struct MoserVeselovEquation {
  Vector3<Number> a;       ///< (h/2) J^-1 M
  Vector3<Number> ratios;  ///< (J2 - J3)/J1 and cyclic

  Vector3<Number> next(const Vector3<Number>& c, Number share) const {
    return (Number(1) + squaredNorm(c)) * share * a + componentProduct(ratios, products(c));
  }
  static Vector3<Number> products(const Vector3<Number>& c) {
    return {c.y * c.z, c.z * c.x, c.x * c.y};
  }
};

/// The step of MoserVeselov, whatever its order.
template <typename Number>
struct MoserVeselovStep {
  using State = StepState<Number>;
  static constexpr bool kMomentumInBody = true;

  Vector3<Number> half;         ///< (h/2) J^-1 [1/(kg m^2/s)]
  Vector3<Number> differences;  ///< J2 - J3 and cyclic [kg m^2]
  Vector3<Number> ratios;       ///< (J2 - J3)/J1 and cyclic
  Number h;                     ///< [s]

  /// Like MidpointStep::stepMomentum().
  template <typename Rest>
  Quaternion<Number> stepMomentum(StepState<Number>& state, const Rest& rest) const {
    const MoserVeselovEquation<Number> equation{componentProduct(half, state.momentum), ratios};
    const auto iterated = fixedPoint(
        equation.a, [&](const Vector3<Number>& c) { return equation.next(c, Number(1)); });
    const Vector3<Number> c = isAll(iterated.isSolved) ? iterated.x : rest(equation, iterated);
    addCompensated(Number(4) / (h * (Number(1) + squaredNorm(c))) *
                       componentProduct(differences, equation.products(c)),
                   state.momentum, state.carry);
    return unitFromHalfTangent(c);
  }
};

}  // namespace rotatebook::physics
