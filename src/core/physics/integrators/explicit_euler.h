// The paper's integrator of a rigid body. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/rigid_state.h"
#include "physics/steps/euler_step.h"

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
  static constexpr bool kTakesDissipation = true;

  ExplicitEuler(const RigidConstants& body, double h)
      : body_(body), quaternionStep_(stepOf(body, h)), matrixStep_(matrixStepOf(body, h)), h_(h) {}

  /// Returns the step of a quaternion, of length h [s].
  static EulerStep<double> stepOf(const RigidConstants& body, double h) {
    return {toNumbers(h / 2 * body.inverseInertia)};
  }

  /// Returns likewise the step of a matrix.
  static EulerMatrixStep<double> matrixStepOf(const RigidConstants& body, double h) {
    return {toNumbers(body.inverseInertia), h};
  }

  void step(RigidState<Eigen::Matrix3d>& state) const {
    if (body_.dissipation == 0) return takeStep(state, matrixStep_);
    const Eigen::Vector3d w = angularVelocityInWorld(body_, state.attitude, state.momentum);
    state.attitude += h_ * (rigid::crossMatrix(w) * state.attitude);
  }

  void step(RigidState<Eigen::Quaterniond>& state) const {
    if (body_.dissipation == 0) return takeStep(state, quaternionStep_);
    const Eigen::Vector3d turn =
        h_ / 2 * angularVelocityInWorld(body_, mapOf(state.attitude), state.momentum);
    const Eigen::Quaterniond rate = Eigen::Quaterniond(0, turn.x(), turn.y(), turn.z());
    state.attitude.coeffs() += (rate * state.attitude).coeffs();
  }

 private:
  RigidConstants body_;
  EulerStep<double> quaternionStep_;
  EulerMatrixStep<double> matrixStep_;
  double h_;
};

}  // namespace rotatebook::physics
