// Integrators on the rotation group: each step is a product of rotations. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Base of these methods: the angular momentum L is constant in world axes, and an attitude has the
/// angular velocity w = angularVelocityInWorld(). Keeps L, and the attitude a rotation, to
/// rounding.
class LieGroupMethod {
 public:
  static constexpr bool kMomentumInBody = false;
  static constexpr bool kTakesDissipation = true;

  LieGroupMethod(const RigidConstants& body, double h) : body_(body), h_(h) {}

 protected:
  /// Returns h w. [rad]
  template <typename Attitude>
  Eigen::Vector3d turnFrom(const Attitude& attitude, const Eigen::Vector3d& momentum) const {
    return h_ * angularVelocityInWorld(body_, mapOf(attitude), momentum);
  }

  template <typename Attitude>
  static Attitude turned(Attitude attitude, const Eigen::Vector3d& rotation) {
    turnInWorld(attitude, rotationBy(rotation));
    return attitude;
  }

 private:
  RigidConstants body_;
  double h_;
};

/// Euler's method on the group, q <- exp(h w) q. Order 1; one evaluation and one exponential per
/// step. Source: Iserles, Munthe-Kaas, Norsett, Zanna, Lie-group methods, Acta Numerica 2000.
class LieEuler : public LieGroupMethod {
 public:
  using LieGroupMethod::LieGroupMethod;

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    state.attitude = turned(state.attitude, turnFrom(state.attitude, state.momentum));
  }
};

/// Commutator-free method of order 4: four evaluations and five exponentials per step. Source:
/// Celledoni, Marthinsen, Owren, Commutator-free Lie group methods, Future Generation Computer
/// Systems 19 (2003).
class CommutatorFree4 : public LieGroupMethod {
 public:
  using LieGroupMethod::LieGroupMethod;

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const Attitude& q = state.attitude;
    const Eigen::Vector3d k1 = turnFrom(q, state.momentum);
    const Attitude q2 = turned(q, k1 / 2);
    const Eigen::Vector3d k2 = turnFrom(q2, state.momentum);
    const Eigen::Vector3d k3 = turnFrom(turned(q, k2 / 2), state.momentum);
    const Eigen::Vector3d k4 = turnFrom(turned(q2, k3 - k1 / 2), state.momentum);
    const Attitude inner = turned(q, (3 * k1 + 2 * k2 + 2 * k3 - k4) / 12);
    state.attitude = turned(inner, (-k1 + 2 * k2 + 2 * k3 + 3 * k4) / 12);
  }
};

}  // namespace rotatebook::physics
