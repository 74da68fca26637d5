// Fits the order of an integrator to its errors.
#pragma once

#include <limits>
#include <span>

namespace rotatebook::study {

/// The error of one run.
struct ErrorAtStep {
  double h = 0;         ///< Step, > 0; no two runs have the same. [s]
  double errorDeg = 0;  ///< Largest angle to the exact attitude, >= 0. [degrees]
};

/// A power law, error ~ h^order.
struct OrderFit {
  double order = std::numeric_limits<double>::quiet_NaN();  ///< NaN if there are too few runs.
  int runs = 0;                                             ///< Number of runs that show the order.
  double shortest = 0;                                      ///< Their shortest step. [s]
  double longest = 0;                                       ///< Their longest step. [s]
};

/// Fewest runs that an order is fitted to.
inline constexpr int kMinRuns = 3;
/// Largest error at which the law can hold: a tenth of a radian. Errors saturate at half a turn.
/// [degrees]
inline constexpr double kLargestErrorDeg = 5.729577951308232;
/// Fewest times the smallest error that an error counts from, if the errors end in a floor.
inline constexpr double kFloorMargin = 10;

/// Fits log error to log h by least squares. `runs` are in any order; only those count that show
/// the law:
/// 1. none with an error over kLargestErrorDeg, and none with longer steps than such a run;
/// 2. none with shorter steps than the run with the smallest error: there, rounding grows;
/// 3. if rule 2 left any out, or the errors fall less than half as steeply toward the smallest as
///    where they fall most steeply, they end in a floor, and kFloorMargin applies.
/// Errors of exactly 0 are left out.
OrderFit fitOrder(std::span<const ErrorAtStep> runs);

}  // namespace rotatebook::study
