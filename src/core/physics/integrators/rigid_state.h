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
  /// The rate eps of a sink of energy, see turnRate(); 0 for none. [kg m^2 s]
  double dissipation = 0;
};

/// Returns the angular velocity at which a body turns whose angular momentum is L, both along its
/// principal axes. [rad/s] Without dissipation it is w = I^-1 L; with it
///
///     O = I^-1 (L + eps a),   a = I^-1 (L x w),
///
/// so that L' = L x O in the body, L stays what it is in the world, and E = L.w/2 falls at the rate
/// eps |a|^2 until the body spins about the axis of its largest moment. A damper inside does so: a
/// ball of the moment J that is free to turn in a fluid of friction c against the body, where
/// eps = J^2/c, if J is small beside the body's moments and J/c beside the time of a turn (Kane's
/// damper; Hughes, Spacecraft Attitude Dynamics, 1986, on the rule of the major axis).
inline Eigen::Vector3d turnRate(const RigidConstants& body, const Eigen::Vector3d& momentum) {
  const Eigen::Vector3d w = body.inverseInertia.cwiseProduct(momentum);
  if (body.dissipation == 0) return w;
  const Eigen::Vector3d a = body.inverseInertia.cwiseProduct(momentum.cross(w));
  return w + body.dissipation * body.inverseInertia.cwiseProduct(a);
}

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

/// Returns A turnRate(A^T L), without dissipation A I^-1 A^T L, for the momentum L in world axes
/// and the map A. [rad/s]
inline Eigen::Vector3d angularVelocityInWorld(const RigidConstants& body,
                                              const Eigen::Matrix3d& map,
                                              const Eigen::Vector3d& momentum) {
  return map * turnRate(body, map.transpose() * momentum);
}

}  // namespace rotatebook::physics
