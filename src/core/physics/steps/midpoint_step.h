// A step of the implicit midpoint rule.
#pragma once

#include "physics/steps/fixed_point.h"

namespace rotatebook::physics {

/// The equation of a step of Midpoint, Mm = M + share (h/2) Mm x I^-1 Mm, where share 1 is the
/// whole step.
template <typename Number>
struct MidpointEquation {
  Vector3<Number> momentum;        ///< M [kg m^2/s]
  Vector3<Number> inverseInertia;  ///< [1/(kg m^2)]
  Number h;                        ///< [s]

  Vector3<Number> next(const Vector3<Number>& middle, Number share) const {
    return momentum +
           share * h / Number(2) * cross(middle, componentProduct(inverseInertia, middle));
  }
};

/// The step of Midpoint.
template <typename Number>
struct MidpointStep {
  using State = StepState<Number>;
  static constexpr bool kMomentumInBody = true;

  Vector3<Number> inverseInertia;  ///< [1/(kg m^2)]
  Number h;                        ///< [s]

  /// Steps the momentum. Returns the turn that belongs to it, in body axes. `rest` solves what
  /// iteration doesn't: rest(equation, iterated) returns the solution for all; and
  /// rest.unsolved(x, condition) is for the bodies for which the condition doesn't hold.
  template <typename Rest>
  Quaternion<Number> stepMomentum(StepState<Number>& state, const Rest& rest) const {
    const MidpointEquation<Number> equation{state.momentum, inverseInertia, h};
    const auto iterated = fixedPoint(state.momentum, [&](const Vector3<Number>& middle) {
      return equation.next(middle, Number(1));
    });
    const Vector3<Number> middle = isAll(iterated.isSolved) ? iterated.x : rest(equation, iterated);
    Vector3<Number> half = h / Number(2) * componentProduct(inverseInertia, middle);
    const Number size = squaredNorm(half);
    const auto isPossible = size - size == Number(0);
    if (!isAll(isPossible)) [[unlikely]]
      half = rest.unsolved(half, isPossible);
    addCompensated(Number(2) * cross(middle, half), state.momentum, state.carry);
    return unitFromHalfTangent(half);
  }
};

}  // namespace rotatebook::physics
