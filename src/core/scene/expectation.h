// Bounds on measured quantities of a motion, and the check of a trajectory against them.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "scene/measure.h"

namespace rotatebook::scene {

/// Bounds on one number; those that are present must hold.
struct Bounds {
  std::optional<double> min{};
  std::optional<double> max{};

  /// Returns whether `value` is within the bounds; NaN never is.
  bool hold(double value) const {
    return value == value && (!min || value >= *min) && (!max || value <= *max);
  }
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Bounds on one measure over a window of a motion. `min` and `max` must hold until the window's
/// end, so that a motion that ends before fails them, whatever it did: because it diverges, or
/// because the clip ends. `risesTo` and `fallsTo` are met once they are reached. diverges_at knows
/// no window; a motion that never diverges meets no expectation on it.
struct Expectation {
  Measure measure = Measure::HalfTurns;
  std::optional<double> min{};                          ///< Never below this.
  std::optional<double> max{};                          ///< Never above this.
  std::optional<double> risesTo{};                      ///< Reaches this or more at some moment.
  std::optional<double> fallsTo{};                      ///< Reaches this or less at some moment.
  double from = 0;                                      ///< The window's start. [s]
  double to = std::numeric_limits<double>::infinity();  ///< The window's end. [s]
  /// Labels of values on the axes: a column and a row of [grid], an x and a curve of [study];
  /// without one, of all.
  std::array<std::optional<std::string>, 2> at{};

  /// Returns the bounds on what doesn't change.
  Bounds bounds() const { return {min, max}; }
  friend bool operator==(const Expectation&, const Expectation&) = default;
};

/// The measured range of an expectation's measure, and whether the bounds are met.
struct ExpectationResult {
  Expectation expectation;
  double lowest = 0;   ///< Lowest value in the window; NaN if it holds no sample.
  double highest = 0;  ///< Highest value in the window; NaN if it holds no sample.
  bool met = false;    ///< False for an empty window.
  /// The end of the motion, if it comes too early for `min` and `max`. [s]
  std::optional<double> endsEarly{};
};

/// Checks `trajectory` against each of `expectations`, in their order.
std::vector<ExpectationResult> check(const physics::Trajectory& trajectory,
                                     std::span<const Expectation> expectations);

}  // namespace rotatebook::scene
