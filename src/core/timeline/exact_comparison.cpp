#include "timeline/exact_comparison.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/elementary.h"
#include "physics/simulate.h"
#include "recording/gyroscope.h"
#include "timeline/motion_summary.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

double angleDegBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return arcTangent(a.cross(b).norm(), a.dot(b)) * kDegreesPerRadian;
}

/// Takes the one of two drifts that is larger, whatever its sign.
void takeLarger(double drift, double& largest) {
  if (std::fabs(drift) > std::fabs(largest)) largest = drift;
}

std::vector<double> timesOf(const std::vector<Sample>& samples) {
  std::vector<double> times;
  for (const Sample& sample : samples) times.push_back(sample.time);
  return times;
}

std::vector<double> meansOf(std::span<const double> values, std::size_t count) {
  std::vector<double> means;
  for (; values.size() >= count; values = values.subspan(count)) {
    const auto first = values.first(count);
    means.push_back(std::accumulate(first.begin(), first.end(), 0.0) / static_cast<double>(count));
  }
  return means;
}

}  // namespace

std::vector<Sample> exactAt(physics::MotionSettings motion, const std::vector<Sample>& samples) {
  motion.simulation.model = physics::Model::Exact;
  return physics::simulate(motion, timesOf(samples)).samples;
}

Comparison compared(const std::vector<Sample>& samples, const std::vector<Sample>& exact) {
  const auto part = [](double value, double of) { return of > 0 ? value / of : 1; };
  Comparison result;
  result.times = timesOf(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample &one = samples[i], &other = exact[i];
    result.energy.push_back(part(one.total(), other.total()));
    result.momentum.push_back(part(one.angularMomentum.norm(), other.angularMomentum.norm()));
    result.errorDeg.push_back(one.errorDeg);
    result.turnDeg.push_back(angleDegBetween(one.angularMomentum, other.angularMomentum));
  }
  return result;
}

void relateToFirst(Comparison& comparison, const Verdict& verdict) {
  for (std::vector<double>* const ratios : {&comparison.energy, &comparison.momentum}) {
    const double first = inner(*ratios, verdict).front();
    for (double& ratio : *ratios) ratio /= first;
  }
}

double setErrors(Comparison& comparison, const std::vector<Sample>& samples,
                 const std::vector<Sample>& exact) {
  std::array<std::vector<double>, 3> parts;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d turn =
        recording::turnOf(exact[i].attitude.conjugate() * samples[i].attitude) * kDegreesPerRadian;
    comparison.errorDeg[i] = turn.norm();
    for (int k = 0; k < 3; ++k) parts[static_cast<std::size_t>(k)].push_back(turn[k]);
  }
  double variance = 0;
  for (const std::vector<double>& part : parts) {
    const double scatter = scatterOf(part, comparison.times);
    variance += scatter * scatter;
  }
  return std::sqrt(variance);
}

void takeMeasures(const Comparison& comparison, const std::vector<Sample>& exact,
                  Verdict& verdict) {
  verdict.errorDeg = verdict.energyDrift = verdict.momentumDrift = 0;
  verdict.visibleFrom.reset();
  for (std::size_t i = 0; i < comparison.times.size(); ++i) {
    verdict.errorDeg = std::max(verdict.errorDeg, comparison.errorDeg[i]);
    if (!verdict.visibleFrom && comparison.errorDeg[i] > kVisibleErrorDeg)
      verdict.visibleFrom = comparison.times[i];
  }
  const auto energy = inner(comparison.energy, verdict);
  const auto momentum = inner(comparison.momentum, verdict);
  for (const double ratio : energy) takeLarger(ratio - 1, verdict.energyDrift);
  for (const double ratio : momentum) takeLarger(ratio - 1, verdict.momentumDrift);
  verdict.momentumTurnDeg = std::ranges::max(inner(comparison.turnDeg, verdict));
  verdict.endErrorDeg = comparison.errorDeg.back();
  verdict.endEnergyDrift = energy.back() - 1;
  verdict.endMomentumDrift = momentum.back() - 1;
  verdict.halfTurnsDue = exact.back().halfTurns;
}

std::size_t samplesAMean(double scatter, std::size_t count) {
  constexpr double kNoise = 1e-4;
  constexpr std::size_t kMost = 16, kFewest = 20;  // samples of a mean, and means
  return scatter > kNoise ? std::clamp<std::size_t>(count / kFewest, 1, kMost) : 1;
}

Changes changesIn(const Comparison& comparison, const Verdict& verdict) {
  // Of the largest of 10,000 normal numbers, on both sides.
  constexpr double kSigmas = 8;
  // Noise of slopes of order 4, beside that of their difference from order 2, measured 0.6.
  constexpr double kOfNoise = 0.7;
  const auto times = inner(comparison.times, verdict);
  const auto energy = inner(comparison.energy, verdict);
  const auto momentum = inner(comparison.momentum, verdict);
  Changes changes;
  changes.energyScatter = scatterOf(energy, times);
  changes.momentumScatter = scatterOf(momentum, times);
  const std::size_t count = samplesAMean(changes.scatter(), times.size());
  changes.energy = driftOf(meansOf(energy, count));
  changes.momentum = driftOf(meansOf(momentum, count));
  const double noise = kOfNoise * changes.momentumScatter, all = verdict.spins.uncertainty;
  const double uncertainty = std::sqrt(std::max(all * all - noise * noise, 0.0));
  const double sigmas = kSigmas / std::sqrt(static_cast<double>(count));
  changes.energyBound += sigmas * changes.energyScatter + 8 * uncertainty;
  changes.momentumBound += sigmas * changes.momentumScatter + 4 * uncertainty;
  changes.ofASample += kSigmas * changes.momentumScatter + 4 * all;
  return changes;
}

}  // namespace rotatebook::timeline
