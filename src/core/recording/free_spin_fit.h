// The free motion of a spin that fits measured rates best. Inside the room only.
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "recording/read_recording.h"

namespace rotatebook::recording {

/// Five entries of the inertia tensor, whose trace is 1, and three of the angular velocity at the
/// start. [rad/s]
inline constexpr int kParameters = 8;
using Parameters = Eigen::Matrix<double, kParameters, 1>;
using Readings = std::span<const InertialReading>;

Eigen::Matrix3d tensorOf(const Parameters& p);
/// Returns the parameters of a tensor, which is divided by its trace, and of a start. [rad/s]
Parameters parametersOf(Eigen::Matrix3d tensor, const Eigen::Vector3d& start);
/// Returns the principal moments, smallest first.
Eigen::Vector3d principalMoments(const Eigen::Matrix3d& tensor);

/// A 3x9 matrix that maps the entries xx, yy, zz, xy, xz, yz of a tensor and the angular momentum
/// over `unit` to R I w - L, for a moment of the body. [rad/s]
Eigen::Matrix<double, 3, 9> momentumBalance(const RecordedMoment& moment, double unit);
/// Returns the tensor of the first six entries of a vector of nine.
Eigen::Matrix3d tensorFrom(const Eigen::Matrix<double, 9, 1>& entries);

/// Start values of the fit, and how far the motion determines them.
struct Linear {
  Eigen::Matrix3d tensor;
  double gap = 0;     ///< TossFit::gap
  double change = 0;  ///< Of the angular momentum, root mean square over its size. [-]
};

/// Solves R I w - L = 0 over a flight, whose attitudes R follow from its rates, for I and L.
Linear solveLinear(Readings flight);

/// A free motion that is fitted to rates.
struct FreeSpinFit {
  Parameters parameters;
  Eigen::Matrix<double, kParameters, kParameters> covariance;
  double residual = 0;  ///< Root mean square. [rad/s]
};

/// Fits a free motion to the rates of a flight by Gauss and Newton's method, from `p` on. The
/// covariance is by the scatter of the rates and by `biasVariance`, of a bias that shifts all
/// rates of an axis alike. [rad^2/s^2]
FreeSpinFit fitFreeSpin(Readings flight, Parameters p, const Eigen::Vector3d& biasVariance);

}  // namespace rotatebook::recording
