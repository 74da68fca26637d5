// How long a body spins about its median axis from one flip to the next.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "physics/inertia.h"
#include "physics/trajectory.h"

namespace rotatebook::physics {

/// Times at which the angular velocity about the body's median axis changes its sign, ascending.
/// [s] Between two samples it is taken for a straight line, which it is nearly, as its second
/// derivative is 0 where it is: the error is below 1e-3 of the sample interval as long as that is
/// under a tenth of the time in which a deviation grows e-fold.
std::vector<double> flipTimes(const Trajectory& trajectory, const PrincipalAxes& inertia);

/// Mean time from one of the ascending `times` to the next; NaN of fewer than two. [s]
double meanInterval(std::span<const double> times);

/// What that interval tends to, for a free rigid body that starts close to the median axis with
/// this angular velocity along the body's axes [rad/s]:
///     (2/lambda) ln(4/sqrt(m1)),  lambda = W sqrt((I2-I1)(I3-I2)/(I1 I3)),
///     m1 = (I3-I1) |I3 (I3-I2) w3^2 - I1 (I2-I1) w1^2| / (I2 (I2-I1) (I3-I2) W^2),
/// where W is its length and I1 <= I2 <= I3. Turned by a small angle eps toward axis 3 that is
/// m1 = kappa3 eps^2 with kappa3 = I3 (I3-I1)/(I2 (I2-I1)); toward axis 1, kappa1 = I1 (I3-I1)/(I2
/// (I3-I2)) instead. The relative error falls as eps^2. Between the two directions lies the
/// separatrix, on which it is infinite, as without any turn, or without three different moments.
double flipLaw(const PrincipalAxes& inertia, const Eigen::Vector3d& angularVelocity);

/// The median axis, a unit vector along the body's axes.
Eigen::Vector3d medianAxis(const PrincipalAxes& inertia);

}  // namespace rotatebook::physics
