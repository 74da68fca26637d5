// The state that steps of any type of number change.
#pragma once

#include "physics/steps/number.h"
#include "physics/steps/vector.h"

namespace rotatebook::physics {

/// A rigid body's state: of one body, or of as many as a number has.
template <typename Number>
struct StepState {
  Quaternion<Number> attitude;  ///< World from principal axes.
  Vector3<Number> momentum;     ///< Angular momentum, in world or body axes. [kg m^2/s]
  Vector3<Number> carry;        ///< Like RigidState::momentumCarry. [kg m^2/s]
};

/// The state of a rigid body whose attitude is a matrix.
template <typename Number>
struct MatrixState {
  Matrix3<Number> attitude;  ///< World from principal axes.
  Vector3<Number> momentum;  ///< In world axes. [kg m^2/s]
};

/// Returns A^T L of the momentum L in world axes: with q = (s, u), L - s t + u x t, t = 2 u x L.
template <typename Number>
Vector3<Number> turnedToBody(const StepState<Number>& state) {
  const Vector3<Number> u = state.attitude.vec();
  const Vector3<Number> t = cross(u, Number(2) * state.momentum);
  return (state.momentum - state.attitude.w * t) + cross(u, t);
}
template <typename Number>
Vector3<Number> turnedToBody(const MatrixState<Number>& state) {
  return transposedProduct(state.attitude, state.momentum);
}

/// Undoes drift: takes the nearest quaternion of unit norm.
template <typename Number>
[[gnu::always_inline]] inline void normalize(Quaternion<Number>& attitude) {
  attitude = scaled(attitude, inverseRoot(squaredNorm(attitude)));
}

/// Adds `increment` to `sum` with what rounding has left over before (Kahan's summation).
template <typename Number>
void addCompensated(const Vector3<Number>& increment, Vector3<Number>& sum,
                    Vector3<Number>& carry) {
  const Vector3<Number> whole = increment + carry;
  const Vector3<Number> next = sum + whole;
  carry = whole - (next - sum);
  sum = next;
}

}  // namespace rotatebook::physics
