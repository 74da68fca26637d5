// The free motion of a spin that fits measured rates best. Inside the room only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "recording/inertial_recording.h"

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

/// The entries xx, yy, zz, xy, xz, yz of a tensor.
using Entries = Eigen::Matrix<double, 6, 1>;
Eigen::Matrix3d tensorFrom(const Entries& entries);
/// A matrix that maps the entries of a tensor I to the angular momentum R I w. [rad/s]
using MomentumMatrix = Eigen::Matrix<double, 3, 6>;
MomentumMatrix momentumMatrix(const RecordedMoment& moment);
/// Returns the mean of the moments from `start` to before `end`.
MomentumMatrix meanMomentum(const std::vector<RecordedMoment>& moments, std::size_t start,
                            std::size_t end);

/// Returns the angular velocity of a free body `interval` after it was `spin`. [s, rad/s]
Eigen::Vector3d freeSpinAfter(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& spin,
                              double interval);

/// Start values of the fit, and how far the motion determines them.
struct Linear {
  Eigen::Matrix3d tensor;
  double gap = 0;     ///< TossFit::gap
  double change = 0;  ///< Of the angular momentum, root mean square over its size. [-]
};

/// Solves R I w = L over a flight, whose attitudes R follow from its rates, for I. L is constant,
/// but for gaps in which the attitude can't be followed: another is taken after each of breaksIn().
Linear solveLinear(Readings flight);

/// Returns whether the readings can be followed from one to the next, and a body's tensor is found:
/// else a fit may take seconds.
bool isFollowed(Readings flight, const Parameters& start);

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

/// Fits likewise from `start` and, where that leaves more than three times the noise and than a
/// thousandth of the spin, from a ball, and of three turns or more by fits to parts that grow: the
/// fit that leaves least. [rad/s]
FreeSpinFit nearestFreeSpin(Readings flight, const Parameters& start,
                            const Eigen::Vector3d& biasVariance, double noise);

}  // namespace rotatebook::recording
