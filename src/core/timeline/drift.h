// Changes of a quantity that free motion keeps. Inside the room only.
#pragma once

#include <span>

namespace rotatebook::timeline {

/// The changes of a series of values at ascending times.
struct Drift {
  double range = 0;   ///< The largest value minus the smallest.
  double change = 0;  ///< The last value minus the first.
  double rise = 0;    ///< The largest from one value to a later one, >= 0.
  double fall = 0;    ///< Likewise, downwards, >= 0.

  /// Returns whether the values go one way, rather than away and back: what they rise and fall in
  /// the other direction is less than half of the range.
  bool isTrend() const { return (rise < fall ? rise : fall) < range / 2; }
};

/// Returns the changes of at least one value.
Drift driftOf(std::span<const double> values);

/// Returns the standard deviation of the noise from one value to the next, by the deviations from
/// the cubics through two neighbours on each side: that of normal noise of which a fiftieth is as
/// large as of these, so that noise of a part of the motion counts, but single values don't. 0 for
/// fewer than five values.
double scatterOf(std::span<const double> values, std::span<const double> times);

}  // namespace rotatebook::timeline
