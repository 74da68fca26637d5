#include "scene/expectation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

namespace rotatebook::scene {
namespace {

// Tolerance for the edges of a window, as a fraction of the sample interval: an edge written as 0.7
// may miss its sample's time by rounding.
constexpr double kEdgeTolerance = 1e-6;

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

MeasuredRange rangeOver(std::span<const physics::Sample> window, const physics::Sample& start,
                        Measure measure) {
  MeasuredRange result = rangeOn(window.front(), start, measure);
  for (const physics::Sample& sample : window) {
    const MeasuredRange here = rangeOn(sample, start, measure);
    result.lowest = std::min(result.lowest, here.lowest);
    result.highest = std::max(result.highest, here.highest);
  }
  return result;
}

MeasuredRange measured(const physics::Trajectory& trajectory, const Expectation& expectation) {
  const auto window = samplesWithin(trajectory, expectation.from, expectation.to);
  if (window.empty()) return {};
  if (expectation.measure == Measure::HalfTurns) {
    const double made = window.back().halfTurns - window.front().halfTurns;
    return {made, made};
  }
  if (expectation.measure == Measure::DivergesAt) {
    const double time = trajectory.divergedAt.value_or(std::numeric_limits<double>::infinity());
    return {time, time};
  }
  return rangeOver(window, trajectory.samples.front(), expectation.measure);
}

// Returns the end of a motion that min or max outlive. The last frame lasts for an interval, too.
std::optional<double> earlyEnd(const physics::Trajectory& trajectory,
                               const Expectation& expectation) {
  if (expectation.measure == Measure::DivergesAt || !(expectation.min || expectation.max)) {
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
bool meets(const MeasuredRange& range, const Expectation& expectation) {
  if (!(range.lowest <= range.highest)) return false;
  if (expectation.measure == Measure::DivergesAt && std::isinf(range.lowest)) return false;
  return (!expectation.min || range.lowest >= *expectation.min) &&
         (!expectation.max || range.highest <= *expectation.max) &&
         (!expectation.risesTo || range.highest >= *expectation.risesTo) &&
         (!expectation.fallsTo || range.lowest <= *expectation.fallsTo);
}

}  // namespace

std::vector<ExpectationResult> check(const physics::Trajectory& trajectory,
                                     std::span<const Expectation> expectations) {
  requireSameLayout();
  std::vector<ExpectationResult> results;
  for (const Expectation& expectation : expectations) {
    const MeasuredRange range = measured(trajectory, expectation);
    const std::optional<double> end = earlyEnd(trajectory, expectation);
    results.push_back(
        {expectation, range.lowest, range.highest, meets(range, expectation) && !end, end});
  }
  return results;
}

}  // namespace rotatebook::scene
