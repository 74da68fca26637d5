// Attitudes from a gyroscope's rates, and rates from attitudes.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "recording/recorded_motion.h"

namespace rotatebook::recording {

/// A gyroscope's reading.
struct Rate {
  double time = 0;                           ///< [s]
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< In body axes. [rad/s]
};

/// Returns the rotation by a vector along its axis, as long as its angle. [rad]
Eigen::Quaterniond rotationBy(const Eigen::Vector3d& turn);
/// Returns the shortest such vector of a unit quaternion. [rad]
Eigen::Vector3d turnOf(const Eigen::Quaterniond& rotation);

/// Integrates at least two rates at ascending times: the first attitude is the identity. Magnus
/// method of order 4 (Iserles, Nørsett 1999) with the rates at Gauss points, from cubics through
/// two readings on each side; the times needn't be even, see stencilAround().
std::vector<RecordedMoment> integrateRates(const std::vector<Rate>& rates);

/// Returns the integral of the rates, by the same cubics, over the gap after reading `index`. [rad]
Eigen::Vector3d meanTurnInGap(const std::vector<Rate>& rates, std::size_t index);

/// Sets the spin of at least two moments from their attitudes: the slope at each moment of the
/// polynomial through the turns to its neighbours, two on each side or, at an end, as near as there
/// are. Exact for a steady spin; of order 4 for others, with even or uneven times. With
/// `neighbours` on each side other than two, the order is twice that.
void differentiateAttitudes(std::vector<RecordedMoment>& moments, std::size_t neighbours = 2);

}  // namespace rotatebook::recording
