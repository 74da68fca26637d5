// The state of a free rigid body, on which its integrators work. Inside the room only.
#pragma once

#include <concepts>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "rigid/inertia.h"

namespace rotatebook::physics {

/// The constants of a motion, along the body's principal axes.
struct RigidConstants {
  Eigen::Vector3d inertia;         ///< [kg m^2]
  Eigen::Vector3d inverseInertia;  ///< [1/(kg m^2)]
  /// Angular momentum at t = 0, or just after the last nudge. [kg m^2/s]
  Eigen::Vector3d momentum;
};

/// A body's state; Attitude is Eigen::Quaterniond or Eigen::Matrix3d, world from principal axes.
template <typename Attitude>
struct RigidState {
  Attitude attitude;
  Eigen::Vector3d momentum;  ///< Angular momentum, in world or body axes. [kg m^2/s]
  /// Rest of it that rounding has cut off, for integrators whose sums are compensated. [kg m^2/s]
  Eigen::Vector3d momentumCarry{0, 0, 0};
};

/// An integrator that steps attitudes of this type.
template <typename Method, typename Attitude>
concept StepsAttitude = requires(const Method& method, RigidState<Attitude>& state) {
  { method.step(state) } -> std::same_as<void>;
};

/// An integrator of a rigid body: made from the body's constants and the length of a step [s], it
/// states in which axes it keeps the momentum, and steps both types of attitude.
template <typename Method>
concept RigidIntegrator = std::constructible_from<Method, const RigidConstants&, double> &&
    std::same_as<decltype(Method::kMomentumInBody), const bool> &&
    StepsAttitude<Method, Eigen::Quaterniond> && StepsAttitude<Method, Eigen::Matrix3d>;

/// Returns w = A I^-1 A^T L for the momentum L in world axes and the map A. [rad/s]
inline Eigen::Vector3d angularVelocityInWorld(const RigidConstants& body,
                                              const Eigen::Matrix3d& map,
                                              const Eigen::Vector3d& momentum) {
  return map * body.inverseInertia.cwiseProduct(map.transpose() * momentum);
}

}  // namespace rotatebook::physics
