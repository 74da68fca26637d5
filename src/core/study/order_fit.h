// The order of an integrator, as its errors show it.
#pragma once

#include <limits>
#include <span>

namespace rotatebook::study {

/// The error of one run.
struct ErrorAtStep {
  double h = 0;         ///< Step, > 0; no two runs have the same. [s]
  double errorDeg = 0;  ///< Largest angle to the exact attitude, >= 0. [degrees]
};

/// A power law error ~ h^order.
struct OrderFit {
  double order = std::numeric_limits<double>::quiet_NaN();  ///< NaN of too few runs.
  int runs = 0;                                             ///< How many show the order.
  double shortest = 0;                                      ///< Their shortest step. [s]
  double longest = 0;                                       ///< Their longest step. [s]
};

/// Fewest runs that an order is fitted to.
inline constexpr int kMinRuns = 3;
/// Largest error at which the law can hold: a tenth of a radian. An error saturates at half a turn.
/// [degrees]
inline constexpr double kLargestErrorDeg = 5.729577951308232;
/// Where the errors end in a floor, only those this many times as large as the smallest count.
inline constexpr double kFloorMargin = 10;

/// Least squares of log error on log h over those runs, in any order, that show the law:
/// 1. none over kLargestErrorDeg, and none with longer steps than such a one;
/// 2. none with shorter steps than the run of the smallest error: there, rounding grows;
/// 3. if 2 left any out, or the errors fall less than half as steeply toward the smallest as where
///    they fall most steeply, they end in a floor, and kFloorMargin applies.
/// Errors of exactly 0 show nothing.
OrderFit fitOrder(std::span<const ErrorAtStep> runs);

}  // namespace rotatebook::study
