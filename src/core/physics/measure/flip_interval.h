// The time between the flips of a body that spins about its middle axis.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/trajectory.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Returns the times at which the angular velocity about the body's middle axis changes sign,
/// ascending. [s] Interpolates linearly between samples: its second derivative is 0 where it is 0,
/// so the error is below 1e-3 of the sample interval as long as that is under a tenth of the time
/// in which a deviation grows e-fold.
std::vector<double> flipTimes(const Trajectory& trajectory, const rigid::PrincipalAxes& inertia);

/// Returns the rate of a body's spin about `axis`, given in body axes. [rad/s]
double spinAbout(const Eigen::Vector3d& axis, const Eigen::Quaterniond& attitude,
                 const Eigen::Vector3d& angularVelocity);
/// Returns the time of the flip between samples at `time` and `interval` later [s], if there the
/// rates `before` and `after` have different signs.
std::optional<double> flipBetween(double time, double interval, double before, double after);

/// Returns the mean time from one of the ascending `times` to the next; NaN of fewer than two. [s]
double meanInterval(std::span<const double> times);

/// Returns the rate at which a small tilt of the spin from the middle axis grows, over the spin:
/// sqrt((I2-I1)(I3-I2)/(I1 I3)), 0 if two moments are equal.
double tiltGrowth(const rigid::PrincipalAxes& inertia);

/// Returns the limit of the flip interval for a free rigid body that starts close to the middle
/// axis with this angular velocity in body axes [rad/s]:
///     (2/lambda) ln(4/sqrt(m1)),  lambda = W sqrt((I2-I1)(I3-I2)/(I1 I3)),
///     m1 = (eps/sin eps)^2 (I3-I1) |I3 (I3-I2) w3^2 - I1 (I2-I1) w1^2| / (I2 (I2-I1) (I3-I2) W^2),
/// where W is the length of the angular velocity, eps its angle to the middle axis, and
/// I1 <= I2 <= I3. Toward axis 3, m1 = kappa3 eps^2 with kappa3 = I3 (I3-I1)/(I2 (I2-I1)); toward
/// axis 1, kappa1 = I1 (I3-I1)/(I2 (I3-I2)) replaces kappa3. The relative error falls as eps^2. The
/// limit is infinite on the separatrix, which lies between the two directions, on the middle axis
/// itself, and if two moments are equal.
double asymptoticFlipInterval(const rigid::PrincipalAxes& inertia,
                              const Eigen::Vector3d& angularVelocity);

/// Returns the middle axis, a unit vector in body axes.
Eigen::Vector3d middleAxis(const rigid::PrincipalAxes& inertia);

}  // namespace rotatebook::physics
