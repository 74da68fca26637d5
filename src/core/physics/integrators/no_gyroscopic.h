// The rule of game engines that leave the gyroscopic torque out. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Keeps the angular velocity w constant in world axes, and turns the body about it by h w, as if
/// no spin needed a torque to keep its axis. Turning about the axis w for ever, whatever the
/// inertia, leaves w constant in body axes, too. Order 0: short steps lead to this motion, not to
/// the exact one. Keeps the energy, the size of L and the rotation to rounding, while L circles w.
/// One exponential per step.
///
/// Emulates the documented rule, in double precision and without damping, of: PhysX without
/// PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES, which is off by default; Jolt without
/// BodyCreationSettings::mApplyGyroscopicForce, off by default; Bullet's btRigidBody with no flags.
class NoGyroscopic {
 public:
  static constexpr bool kMomentumInBody = true;

  NoGyroscopic(const RigidConstants& body, double h) : turn_(h * body.inverseInertia) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    turnInBody(state.attitude, rotationBy(turn_.cwiseProduct(state.momentum)));
  }

 private:
  Eigen::Vector3d turn_;  // h I^-1
};

}  // namespace rotatebook::physics
