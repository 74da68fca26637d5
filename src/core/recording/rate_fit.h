// Given rates as multiples of the slopes of attitudes, with a bias. Inside the room only.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "recording/recorded_motion.h"

namespace rotatebook::recording {

using Vectors = std::vector<Eigen::Vector3d>;

/// Difference of a factor from 1 up to which it may be of the motion, not of a unit. [-]
inline constexpr double kSameFactor = 0.05;

/// Returns whether a factor is 1, to kSameFactor.
bool isOne(double factor);

/// Rates as a multiple of slopes.
struct Multiple {
  double factor = 0;
  double left = std::numeric_limits<double>::infinity();  ///< Relative to the multiple.
};

/// Fits the rates inside, without the two at each end, whose slopes are one-sided.
Multiple multipleOf(const Vectors& rates, const Vectors& slopes);

/// Returns the root mean square of the rates inside minus the slopes, relative to the slopes' own.
double relativeDifference(const Vectors& rates, const Vectors& slopes);

/// A fit, and the root mean square of what it leaves, relative to that of the slopes.
struct RateFitted {
  RateFit fit{};
  double left = 0;
};

/// Fits the rates inside by a factor, a bias or, only where one alone leaves more, both. What isn't
/// significant beside what is left, is left out.
RateFitted fitRates(const Vectors& rates, const Vectors& slopes);

}  // namespace rotatebook::recording
