// The rule of game engines that add the gyroscopic torque like any other torque. Inside the room
// only.
#pragma once

#include <Eigen/Geometry>

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Semi-implicit Euler: M += h M x w with w = I^-1 M, then the body turns by h w with the new w.
/// The result is the same whether an engine keeps w in world or in body axes, as a turn about w
/// leaves w unchanged. Order 1; keeps the rotation to rounding; each step adds h^2 |M x w|^2 to
/// |M|^2, and the energy grows. One exponential per step.
///
/// Emulates the documented rule, in double precision and without damping, of: MuJoCo's integrator
/// Euler (mju_quatIntegrate turns the body); Bullet's BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT
/// (btRigidBody::computeGyroscopicForceExplicit, whose header says that it gains energy).
class ExplicitGyroscopic {
 public:
  static constexpr bool kMomentumInBody = true;

  ExplicitGyroscopic(const RigidConstants& body, double h) : turn_(h * body.inverseInertia) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    state.momentum += state.momentum.cross(turn_.cwiseProduct(state.momentum));
    turnInBody(state.attitude, rotationBy(turn_.cwiseProduct(state.momentum)));
  }

 private:
  Eigen::Vector3d turn_;  // h I^-1
};

}  // namespace rotatebook::physics
