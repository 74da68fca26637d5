// What the integrators of a free rigid body work on.
#pragma once

#include <Eigen/Core>

#include "physics/inertia.h"

namespace rotatebook::physics {

/// The constants of a motion, along the body's principal axes.
struct RigidConstants {
  Eigen::Vector3d inertia;         ///< [kg m^2]
  Eigen::Vector3d inverseInertia;  ///< [1/(kg m^2)]
  Eigen::Vector3d momentum;        ///< Angular momentum at t = 0. [kg m^2/s]
};

/// Attitude is Eigen::Quaterniond or Eigen::Matrix3d, world from principal axes. An integrator M is
/// a type that is made from RigidConstants and a step h [s], with
///   static constexpr bool kMomentumInBody   in which axes it keeps the momentum,
///   void step(RigidState<Attitude>&) const  one step.
template <typename Attitude>
struct RigidState {
  Attitude attitude;
  Eigen::Vector3d momentum;  ///< Angular momentum, in the world's or the body's axes. [kg m^2/s]
};

/// w = A I^-1 A^T L of the momentum L in the world's axes and the map A. [rad/s]
inline Eigen::Vector3d angularVelocityInWorld(const RigidConstants& body,
                                              const Eigen::Matrix3d& map,
                                              const Eigen::Vector3d& momentum) {
  return map * body.inverseInertia.cwiseProduct(map.transpose() * momentum);
}

}  // namespace rotatebook::physics
