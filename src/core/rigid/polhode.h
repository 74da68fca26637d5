// The constants of a free rigid body's motion along its polhode.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "base/double_double.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {

/// The curve that a torque-free angular velocity w follows in the body frame, and the pace of the
/// motion. About one body axis w goes as cn u, about the others as sn u and dn u; the angular
/// momentum L circles the dn axis. All functions have the parameter m1 = k1^2.
struct Polhode {
  /// w = cosine cn u + sine sn u + delta dn u, each along one body axis. [rad/s]
  Eigen::Vector3d cosine, sine, delta;
  DoubleDouble rate;        ///< u = rate t + start. [1/s]
  DoubleDouble start;       ///< In [-K, K].
  DoubleDouble halfPeriod;  ///< 2K, after which cn and sn change sign; 0 on the separatrix.
  Regime regime{};          ///< Of all such motions.
  double k1 = 0;            ///< sqrt(1 - m) in [0, 1]; 0 on the separatrix.

  /// The cn or the dn axis: the one about which L has the smaller amplitude. L stays at least pi/4
  /// away from it.
  Eigen::Vector3d frameAxis;
  /// The reference frame of L and frameAxis turns about L by precession t + weight (P(u) -
  /// P(start)), where P(u) = J(u) - u / (1 - n) and J is the integral of sn^2 / (1 - n sn^2) from
  /// 0. [rad/s], [rad]
  DoubleDouble precession, weight;
  DoubleDouble weightedHalfPeriod;  ///< weight P(2K); 0 on the separatrix. [rad]
  double n = 0;                     ///< In [-1, 0].
};

/// Returns the polhode of a body with these principal moments [kg m^2] and, at t = 0, this angular
/// velocity along the principal axes [rad/s]; nullopt if the spin is steady, that is w x L = 0,
/// exactly or apart from components under 1e-280 of the largest (under 1e-305 for a spin about the
/// middle axis).
std::optional<Polhode> polhodeOf(const DoubleDouble3& inertia,
                                 const DoubleDouble3& angularVelocity);

}  // namespace rotatebook::rigid
