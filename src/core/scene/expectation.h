// Bounds on measured quantities of a motion, and the check of a trajectory against them.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "physics/trajectory.h"

namespace rotatebook::scene {

/// A measurable quantity of a motion. Ratios are to the value at t = 0.
enum class Quantity {
  HalfTurns,        ///< half_turns: number made within the window; one number.
  TiltDeg,          ///< tilt_deg: Sample::tiltDeg.
  EnergyRatio,      ///< energy_ratio: total energy / total energy at the start.
  RotationalRatio,  ///< rotational_ratio: rotational energy / total energy at the start.
  MomentumRatio,    ///< L_ratio: |L| / |L| at the start.
  Stretch,          ///< stretch: every singular value of the map from body to drawn corners.
  ErrorDeg,         ///< error_deg: Sample::errorDeg.
  Regime,           ///< regime: Sample::regime as 1, 0 or -1.
  CentreDrift,      ///< centre_drift: Sample::centreDrift(). [m]
  DivergesAt,  ///< diverges_at: Trajectory::divergedAt; one number, infinite if the motion never
               ///< diverges. [s]
};

/// Returns the name of `quantity` in a scene, e.g. "half_turns".
std::string_view nameOf(Quantity quantity);
/// Returns the meaning of `quantity`, in Markdown.
std::string_view meaningOf(Quantity quantity);
/// Returns the label of a plot's axis for the number that studies make of `quantity`, as gnuplot
/// writes it, with its unit.
std::string_view axisOf(Quantity quantity);
/// Returns the value from which studies measure `quantity`: 1 of ratios and the stretch, else 0.
double restOf(Quantity quantity);
/// Returns all quantities, in the order of the enumeration.
std::span<const Quantity> allQuantities();

/// Returns the value of `quantity` on one sample of a motion whose first sample is `start`: of the
/// stretch, the one farther from 1; of the half-turns, those made so far. diverges_at has none and
/// is NaN.
double valueOn(const physics::Sample& sample, const physics::Sample& start, Quantity quantity);

/// Bounds on one quantity over a window of a motion. `min` and `max` must hold until the window's
/// end, so that a motion that ends before fails them, whatever it did: because it diverges, or
/// because the clip ends. `risesTo` and `fallsTo` are met once they are reached. diverges_at knows
/// no window; a motion that never diverges meets no expectation on it.
struct Expectation {
  Quantity quantity = Quantity::HalfTurns;
  std::optional<double> min{};                          ///< Never below this.
  std::optional<double> max{};                          ///< Never above this.
  std::optional<double> risesTo{};                      ///< Reaches this or more at some moment.
  std::optional<double> fallsTo{};                      ///< Reaches this or less at some moment.
  double from = 0;                                      ///< The window's start. [s]
  double to = std::numeric_limits<double>::infinity();  ///< The window's end. [s]

  friend bool operator==(const Expectation&, const Expectation&) = default;
};

/// The measured range of an expectation's quantity, and whether the bounds are met.
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
