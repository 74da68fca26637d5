// The rule of game engines that add the gyroscopic torque and restore the angular momentum's size.
// Inside the room only.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// The explicit rule's M + h M x w, scaled back to the size of M; then the body turns by h w with
/// the new w. Order 1; keeps the size of L and the rotation to rounding, not the direction of L. A
/// flipping body's energy creeps toward that of the spin about the middle axis, and its flips
/// become ever rarer. One exponential and one square root per step.
///
/// Emulates the documented rule, in double precision and without damping, of: Jolt with
/// BodyCreationSettings::mApplyGyroscopicForce (MotionProperties::ApplyGyroscopicForceInternal);
/// avian's solve_gyroscopic_torque, after it.
class Renormalised {
 public:
  static constexpr bool kMomentumInBody = true;

  Renormalised(const RigidConstants& body, double h) : turn_(h * body.inverseInertia) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const Eigen::Vector3d& before = state.momentum;
    const Eigen::Vector3d after = before + before.cross(turn_.cwiseProduct(before));
    state.momentum = std::sqrt(before.squaredNorm() / after.squaredNorm()) * after;
    turnInBody(state.attitude, rotationBy(turn_.cwiseProduct(state.momentum)));
  }

 private:
  Eigen::Vector3d turn_;  // h I^-1
};

}  // namespace rotatebook::physics
