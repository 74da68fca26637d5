#include "scene/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace rotatebook::scene {
namespace {

// Tolerance for the edges of a window, as a fraction of the sample interval: an edge written as 0.7
// may miss its sample's time by rounding.
constexpr double kEdgeTolerance = 1e-6;

struct QuantityRow {
  std::string_view name;
  std::string_view meaning;
  std::string_view axis;
  double rest = 0;
};

/// Rows in the order of the enumeration.
constexpr std::array<QuantityRow, 10> kQuantityRows{{
    {"half_turns", "how many times the axis that the book was spun about has turned over",
     "flips"},
    {"tilt_deg", "angle between that axis and the angular momentum [degrees]",
     "largest tilt  [degrees]"},
    {"energy_ratio", "total energy / total energy at the start", "largest | E / E_0 − 1 |", 1},
    {"rotational_ratio",
     "kinetic energy of the best-fitting rigid rotation / total energy at the start",
     "largest | rotational E / E_0 − 1 |", 1},
    {"L_ratio", "angular momentum / angular momentum at the start", "largest | L / L_0 − 1 |", 1},
    {"stretch",
     "every singular value of the linear map that best fits the drawn corners; 1 is undeformed",
     "largest | stretch − 1 |", 1},
    {"error_deg", "angle between the attitude and the exact motion's [degrees]",
     "largest angle to the exact motion  [degrees]"},
    {"regime",
     "1 or -1: the angular momentum circles the axis of the largest or the smallest moment of "
     "inertia",
     "regime at the end"},
    {"centre_drift", "distance of the centre of mass from where it started [m]",
     "largest drift of the centre  [m]"},
    {"diverges_at", "time at which the motion diverges, and so ends [s]", "diverges at  [s]"},
}};

const QuantityRow& rowOf(Quantity quantity) {
  return kQuantityRows[static_cast<std::size_t>(quantity)];
}

constexpr auto kQuantities = [] {
  std::array<Quantity, kQuantityRows.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Quantity>(i);
  return all;
}();

struct Range {
  double lowest = std::numeric_limits<double>::quiet_NaN();
  double highest = lowest;
};

std::span<const physics::Sample> samplesWithin(const physics::Trajectory& trajectory, double from,
                                               double to) {
  const double slack = kEdgeTolerance * trajectory.interval;
  const auto& samples = trajectory.samples;
  const auto first = std::ranges::find_if(
      samples, [&](const physics::Sample& sample) { return sample.time >= from - slack; });
  const auto last = std::find_if(first, samples.end(), [&](const physics::Sample& sample) {
    return sample.time > to + slack;
  });
  return {std::to_address(first), static_cast<std::size_t>(last - first)};
}

Range rangeAt(const physics::Sample& sample, const physics::Sample& start, Quantity quantity) {
  const auto one = [](double value) { return Range{value, value}; };
  switch (quantity) {
    case Quantity::TiltDeg:
      return one(sample.tiltDeg);
    case Quantity::EnergyRatio:
      return one(sample.total() / start.total());
    case Quantity::RotationalRatio:
      return one(sample.rotational / start.total());
    case Quantity::MomentumRatio:
      return one(sample.angularMomentum.norm() / start.angularMomentum.norm());
    case Quantity::Stretch:
      return {sample.stretchMin, sample.stretchMax};
    case Quantity::ErrorDeg:
      return one(sample.errorDeg);
    case Quantity::Regime:
      return one(static_cast<double>(sample.regime));
    case Quantity::CentreDrift:
      return one(sample.centreDrift());
    case Quantity::HalfTurns:
    case Quantity::DivergesAt:
      break;  // measured over a window, not on a sample
  }
  return {};
}

Range rangeOver(std::span<const physics::Sample> window, const physics::Sample& start,
                Quantity quantity) {
  Range result = rangeAt(window.front(), start, quantity);
  for (const physics::Sample& sample : window) {
    const Range here = rangeAt(sample, start, quantity);
    result.lowest = std::min(result.lowest, here.lowest);
    result.highest = std::max(result.highest, here.highest);
  }
  return result;
}

Range measure(const physics::Trajectory& trajectory, const Expectation& expectation) {
  const auto window = samplesWithin(trajectory, expectation.from, expectation.to);
  if (window.empty()) return {};
  if (expectation.quantity == Quantity::HalfTurns) {
    const double made = window.back().halfTurns - window.front().halfTurns;
    return {made, made};
  }
  if (expectation.quantity == Quantity::DivergesAt) {
    const double time = trajectory.divergedAt.value_or(std::numeric_limits<double>::infinity());
    return {time, time};
  }
  return rangeOver(window, trajectory.samples.front(), expectation.quantity);
}

// Returns the end of a motion that min or max outlive. The last frame lasts for an interval, too.
std::optional<double> earlyEnd(const physics::Trajectory& trajectory,
                               const Expectation& expectation) {
  if (expectation.quantity == Quantity::DivergesAt || !(expectation.min || expectation.max)) {
    return std::nullopt;
  }
  const double slack = kEdgeTolerance * trajectory.interval;
  if (trajectory.divergedAt) {
    return expectation.to > *trajectory.divergedAt - slack ? trajectory.divergedAt : std::nullopt;
  }
  const double end = trajectory.samples.back().time + trajectory.interval;
  const bool isBeyond = std::isfinite(expectation.to) && expectation.to > end + slack;
  return isBeyond ? std::optional(end) : std::nullopt;
}

// The comparisons are written so that NaN, the range of an empty window, meets no bound.
bool meets(const Range& range, const Expectation& expectation) {
  if (!(range.lowest <= range.highest)) return false;
  if (expectation.quantity == Quantity::DivergesAt && std::isinf(range.lowest)) return false;
  return (!expectation.min || range.lowest >= *expectation.min) &&
         (!expectation.max || range.highest <= *expectation.max) &&
         (!expectation.risesTo || range.highest >= *expectation.risesTo) &&
         (!expectation.fallsTo || range.lowest <= *expectation.fallsTo);
}

}  // namespace

std::string_view nameOf(Quantity quantity) {
  return rowOf(quantity).name;
}

std::string_view meaningOf(Quantity quantity) {
  return rowOf(quantity).meaning;
}

std::string_view axisOf(Quantity quantity) {
  return rowOf(quantity).axis;
}

double restOf(Quantity quantity) {
  return rowOf(quantity).rest;
}

std::span<const Quantity> allQuantities() {
  return kQuantities;
}

double valueOn(const physics::Sample& sample, const physics::Sample& start, Quantity quantity) {
  if (quantity == Quantity::HalfTurns) return sample.halfTurns;
  const Range range = rangeAt(sample, start, quantity);
  const double rest = restOf(quantity);
  return std::fabs(range.lowest - rest) > std::fabs(range.highest - rest) ? range.lowest
                                                                          : range.highest;
}

std::vector<ExpectationResult> check(const physics::Trajectory& trajectory,
                                     std::span<const Expectation> expectations) {
  requireSameLayout();
  std::vector<ExpectationResult> results;
  for (const Expectation& expectation : expectations) {
    const Range range = measure(trajectory, expectation);
    const std::optional<double> end = earlyEnd(trajectory, expectation);
    results.push_back(
        {expectation, range.lowest, range.highest, meets(range, expectation) && !end, end});
  }
  return results;
}

}  // namespace rotatebook::scene
