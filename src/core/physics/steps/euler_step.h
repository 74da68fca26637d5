// Steps of explicit Euler.
#pragma once

#include "physics/steps/step_state.h"

namespace rotatebook::physics {

/// The step of ExplicitEuler for a quaternion, with the momentum in world axes.
template <typename Number>
struct EulerStep {
  using State = StepState<Number>;
  static constexpr bool kMomentumInBody = false;

  Vector3<Number> halfTurn;  ///< (h/2) I^-1 [1/(kg m^2/s)]

  void operator()(StepState<Number>& state) const { turn(state.attitude, turnedToBody(state)); }

  // With q = (s, u) and v = (h/2) I^-1 A^T L, the body's half turn,
  //   (0, A v) q = (-u.v, s v + (2 |q|^2 - 1) u x v)
  // for every q. It takes half as many operations as the matrix, in a chain half as long.
  void turn(Quaternion<Number>& attitude, const Vector3<Number>& inBody) const {
    const Number s = attitude.w;
    const Vector3<Number> u = attitude.vec();
    const Vector3<Number> v = componentProduct(halfTurn, inBody);
    const Vector3<Number> stretched =
        exactProductPlus(Number(2), squaredNorm(attitude), Number(-1)) * u;
    const Vector3<Number> next = (u + s * v) + cross(stretched, v);
    attitude = {s - dot(u, v), next.x, next.y, next.z};
  }
};

/// The step of ExplicitEuler for a matrix A: A += h w x A, with w = A I^-1 A^T L.
template <typename Number>
struct EulerMatrixStep {
  using State = MatrixState<Number>;
  static constexpr bool kMomentumInBody = false;

  Vector3<Number> inverseInertia;  ///< [1/(kg m^2)]
  Number h;                        ///< [s]

  void operator()(MatrixState<Number>& state) const {
    Matrix3<Number>& a = state.attitude;
    const Vector3<Number> turn =
        h * product(a, componentProduct(inverseInertia, transposedProduct(a, state.momentum)));
    a = {a.x + cross(turn, a.x), a.y + cross(turn, a.y), a.z + cross(turn, a.z)};
  }
};

}  // namespace rotatebook::physics
