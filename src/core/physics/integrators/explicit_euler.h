// The paper's integrator of a rigid body. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Explicit Euler with a constant angular momentum L: w = A I^-1 A^T L, then R += h [w]x R for a
/// matrix (A = R) or q += h/2 (0, w) q for a quaternion (A = unnormalisedMatrix(q)). Order 1; keeps
/// only L. Unless normalised, a step lengthens R by sqrt(1 + (h |w|)^2) in all directions
/// perpendicular to w, and multiplies |q|^2 by 1 + (h |w| / 2)^2. A isn't divided by |q|^2: with
/// the division the drawn body would stay rigid and hide the missing normalisation. Normalised, the
/// energy still grows, dE/dt = (h/2) a.I a with the angular acceleration a, until the body spins
/// about its axis of smallest inertia. Source: "Simulating the Unstable Rotation of a Book".
class ExplicitEuler {
 public:
  static constexpr bool kMomentumInBody = false;

  ExplicitEuler(const RigidConstants& body, double h)
      : body_(body), halfTurn_(h / 2 * body.inverseInertia), h_(h) {}

  void step(RigidState<Eigen::Matrix3d>& state) const {
    const Eigen::Vector3d w = angularVelocityInWorld(body_, state.attitude, state.momentum);
    state.attitude += h_ * (rigid::crossMatrix(w) * state.attitude);
  }

  // With q = (s, u) and v = (h/2) I^-1 A^T L, the body's half turn,
  //   A^T L = L - s t + u x t,  t = 2 u x L,  and
  //   (0, A v) q = (-u.v, s v + (2 |q|^2 - 1) u x v),
  // for every q. It takes half as many operations as the matrix, in a chain half as long.
  void step(RigidState<Eigen::Quaterniond>& state) const {
    const double s = state.attitude.w();
    const Eigen::Vector3d u = state.attitude.vec();
    const Eigen::Vector3d t = u.cross(2 * state.momentum);
    const Eigen::Vector3d inBody = (state.momentum - s * t) + u.cross(t);
    const Eigen::Vector3d v = halfTurn_.cwiseProduct(inBody);
    const Eigen::Vector3d stretched = (2 * state.attitude.squaredNorm() - 1) * u;
    state.attitude.w() = s - u.dot(v);
    state.attitude.vec() = (u + s * v) + stretched.cross(v);
  }

 private:
  RigidConstants body_;
  Eigen::Vector3d halfTurn_;  // (h/2) I^-1
  double h_;
};

}  // namespace rotatebook::physics
