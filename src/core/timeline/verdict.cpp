#include "timeline/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "base/elementary.h"
#include "base/number_text.h"
#include "physics/measure/measurement.h"
#include "physics/motion_start.h"
#include "physics/simulate.h"
#include "recording/conventions.h"
#include "recording/gyroscope.h"
#include "timeline/drift.h"
#include "timeline/fitted_start.h"
#include "timeline/motion_summary.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;

// Difference of rates from slopes that is more than that of steps which keep energy and L: of 25 a
// turn by the midpoint rule 0.006, measured.
constexpr double kOfAnotherScale = 0.01;
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

std::vector<Sample> exactAt(physics::MotionSettings motion, const std::vector<Sample>& samples) {
  motion.simulation.model = physics::Model::Exact;
  return physics::simulate(motion, timesOf(samples)).samples;
}

/// A motion beside an exact one, sample by sample.
struct Comparison {
  std::vector<double> times;              // [s]
  std::vector<double> energy, momentum;   // as parts of the exact motion's
  std::vector<double> errorDeg, turnDeg;  // of the attitude, and of L [degrees]
};

/// Compares motions; 1 where the exact motion is at rest after a nudge.
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

/// Returns the values without the two at each end, whose slopes are one-sided, if they are slopes.
template <typename Value>
std::span<const Value> inner(const std::vector<Value>& values, const Verdict& verdict) {
  const bool areSlopes = verdict.spins.source == recording::SpinSource::Slopes;
  const std::size_t left = areSlopes && values.size() > 8 ? 2 : 0;
  return std::span(values).subspan(left, values.size() - 2 * left);
}

/// Returns the largest change of the angular velocity in the world, relative to the first.
double spinChange(std::span<const Sample> samples) {
  const Eigen::Vector3d& start = samples.front().angularVelocity;
  double largest = 0;
  for (const Sample& sample : samples)
    largest = std::max(largest, (sample.angularVelocity - start).norm() / start.norm());
  return largest;
}

/// Makes ratios relative to the first of the inner.
void relateToFirst(std::vector<double>& ratios, const Verdict& verdict) {
  const double first = inner(ratios, verdict).front();
  for (double& ratio : ratios) ratio /= first;
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

/// Changes of energy and of the size of L, and bounds up to which they count as kept.
struct Changes {
  Drift energy, momentum;
  double energyBound = kKept, momentumBound = kKept;

  bool keepEnergy() const { return energy.range < energyBound; }
  bool keepMomentum() const {
    // A swing beside a trend of the energy that is ten times as large is no change of its own.
    const bool isBeside = energy.isTrend() && !momentum.isTrend();
    return momentum.range < std::max(momentumBound, isBeside ? energy.range / 10 : 0);
  }
};

Changes changesIn(const Comparison& comparison, const Verdict& verdict) {
  // Of the largest of 10,000 normal numbers, on both sides.
  constexpr double kSigmas = 8;
  const std::span<const double> times = inner(comparison.times, verdict);
  Changes changes;
  changes.energy = driftOf(inner(comparison.energy, verdict), times);
  changes.momentum = driftOf(inner(comparison.momentum, verdict), times);
  const double uncertainty = verdict.spins.uncertainty;
  changes.energyBound += kSigmas * changes.energy.scatter + 8 * uncertainty;
  changes.momentumBound += kSigmas * changes.momentum.scatter + 4 * uncertainty;
  return changes;
}

/// Returns whether as many half-turns are made as are due, or one is just being made at the end.
bool makesDueHalfTurns(const Verdict& verdict, const Sample& last) {
  const int made = verdict.halfTurns, due = verdict.halfTurnsDue;
  const double fromLimit = std::min(std::fabs(last.tiltDeg - physics::kNearTiltDeg),
                                    std::fabs(last.tiltDeg - physics::kFarTiltDeg));
  const bool isOneOff = made == due + 1 || made + 1 == due;
  return made == due || (isOneOff && fromLimit < 2 * kAgreesDeg);
}

/// Returns whether all is the exact motion's, to `noiseDeg` of the attitudes.
bool agrees(const Verdict& verdict, const Changes& changes, const Sample& last, double noiseDeg) {
  constexpr double kSigmas = 5;
  const double turnBound = 2 * kAgreesDeg + changes.momentumBound * kDegreesPerRadian;
  return verdict.errorDeg < kAgreesDeg + kSigmas * noiseDeg && changes.keepEnergy() &&
         changes.keepMomentum() && verdict.momentumTurnDeg < turnBound &&
         makesDueHalfTurns(verdict, last);
}

/// Returns the error of motions that go one way, or nothing of those that come back.
std::optional<Errs> trendOf(const Changes& changes) {
  const Drift &energy = changes.energy, &momentum = changes.momentum;
  if (changes.keepMomentum()) {
    if (!energy.isTrend()) return std::nullopt;
    return energy.change > 0 ? Errs::GainsEnergy : Errs::LosesEnergy;
  }
  if (changes.keepEnergy()) {
    if (!momentum.isTrend()) return std::nullopt;
    return momentum.change > 0 ? Errs::GainsMomentum : Errs::LosesMomentum;
  }
  if (!energy.isTrend() || !momentum.isTrend()) return std::nullopt;
  if (energy.change > 0) return Errs::GainsBoth;
  return momentum.change > 0 ? Errs::Inconsistently : Errs::LosesBoth;
}

Errs errsOf(const Verdict& verdict, const Changes& changes, const std::vector<Sample>& samples,
            const std::vector<Sample>& exact) {
  if (agrees(verdict, changes, samples.back(), 0)) return Errs::Hardly;
  if (verdict.spins.difference > recording::kContradicts) return Errs::SpinsAreOthers;
  // A spin that the exact motion keeps, too, tells nothing.
  constexpr double kMoves = 0.02, kClearly = 4;
  const double spinBound = std::max(changes.energyBound, changes.momentumBound);
  if (spinChange(inner(samples, verdict)) < spinBound &&
      spinChange(exact) > std::max(kMoves, kClearly * spinBound))
    return Errs::SpinIsFixed;
  // Exact motions have 0.012 at 10 attitudes a turn, and 0.046 at 5, measured.
  constexpr double kTooUncertain = 0.03;
  if (verdict.spins.uncertainty > kTooUncertain) return Errs::TooFewAttitudes;
  const bool keepsBoth = changes.keepEnergy() && changes.keepMomentum();
  const std::optional<Errs> trend = keepsBoth ? std::nullopt : trendOf(changes);
  // Steps that make L much larger or smaller turn it on the way.
  const double turn = verdict.momentumTurnDeg / kDegreesPerRadian;
  const bool turns = verdict.momentumTurnDeg > kTurnsDeg;
  if (turns && !(trend && changes.momentum.range > turn)) return Errs::TurnsMomentum;
  if (trend) return *trend;
  if (verdict.errorDeg < kAgreesDeg) {
    // Slopes over a gap are no spins that were measured.
    const bool areSlopes = verdict.spins.source == recording::SpinSource::Slopes;
    return areSlopes ? Errs::Hardly : Errs::SpinsAreOthers;
  }
  return keepsBoth ? Errs::InPhase : Errs::Swings;
}

/// Returns whether the exact motion may be fitted: that of a recording whose spins aren't exact.
bool mayFit(const physics::MotionSettings& motion, const Verdict& verdict) {
  constexpr double kExact = 1e-7;
  constexpr std::size_t kMinSamples = 12;
  return motion.simulation.model == physics::Model::Recorded && motion.nudges.empty() &&
         verdict.samples >= kMinSamples &&
         (verdict.spins.source == recording::SpinSource::Slopes || verdict.scatter > kExact);
}

/// Returns the largest change of the start's spin, relative to it, that its uncertainty allows.
double largestFit(const Verdict& verdict) {
  // Five points of attitudes with noise have a slope at their end that is as uncertain as 5.7
  // slopes in their middle.
  constexpr double kSigmas = 5, kAtEnd = 5.7, kEndsError = 3;
  const bool areSlopes = verdict.spins.source == recording::SpinSource::Slopes;
  return kSigmas * (areSlopes ? kAtEnd : 1) * verdict.scatter +
         kEndsError * verdict.spins.uncertainty;
}

/// Sets the errors to those from the exact motion, and returns their noise. [degrees]
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

/// Returns the verdict if the motion agrees with the exact one from a start that is fitted.
std::optional<Verdict> fitted(physics::MotionSettings motion, const std::vector<Sample>& samples,
                              Verdict verdict) {
  const FittedStart start = fitStart(physics::modelInertia(motion), samples);
  const Eigen::Vector3d given = motion.initial.value;
  verdict.fittedBy = (start.angularVelocity - given).norm() / given.norm();
  if (*verdict.fittedBy > largestFit(verdict)) return std::nullopt;
  motion.initial.value = start.angularVelocity;
  std::vector<Sample> exact = exactAt(motion, samples);
  for (Sample& sample : exact) {
    sample.attitude = start.attitude * sample.attitude;
    sample.angularMomentum = start.attitude * sample.angularMomentum;
  }
  Comparison comparison = compared(samples, exact);
  const double noiseDeg = setErrors(comparison, samples, exact);
  takeMeasures(comparison, exact, verdict);
  verdict.errs = Errs::HardlyAsFitted;
  if (!agrees(verdict, changesIn(comparison, verdict), samples.back(), noiseDeg))
    return std::nullopt;
  return verdict;
}

}  // namespace

Verdict judge(const physics::MotionSettings& motion, const physics::Trajectory& trajectory) {
  const std::vector<Sample>& samples = trajectory.samples;
  Verdict verdict;
  verdict.samples = samples.size();
  verdict.duration = samples.back().time;
  verdict.halfTurns = samples.back().halfTurns;
  verdict.start = samples.front().regime;
  verdict.end = samples.back().regime;
  if (motion.simulation.model == physics::Model::Recorded)
    verdict.spins = motion.simulation.recorded.motion->spins();
  const std::vector<Sample> exact = exactAt(motion, samples);
  Comparison comparison = compared(samples, exact);
  relateToFirst(comparison.energy, verdict);
  relateToFirst(comparison.momentum, verdict);
  takeMeasures(comparison, exact, verdict);
  const Changes changes = changesIn(comparison, verdict);
  verdict.scatter = std::max(changes.energy.scatter / 2, changes.momentum.scatter);
  verdict.errs = errsOf(verdict, changes, samples, exact);
  if (verdict.errs == Errs::Hardly || !mayFit(motion, verdict)) return verdict;
  return fitted(motion, samples, verdict).value_or(verdict);
}

std::string methodThat(const Verdict& verdict) {
  switch (verdict.errs) {
    case Errs::Hardly:
      return "agrees with the exact motion";
    case Errs::HardlyAsFitted:
      return "agrees with the exact motion, from a start within the uncertainty of its spins";
    case Errs::SpinsAreOthers:
      return "has angular velocities that aren't the slopes of its attitudes, which differ from "
             "the exact motion's by up to " +
             roundedText(verdict.errorDeg, 2) + " degrees";
    case Errs::SpinIsFixed:
      return "keeps the angular velocity fixed in the world, as without a gyroscopic torque";
    case Errs::InPhase:
      return "keeps energy and angular momentum, but not the pace, as with long steps" +
             (verdict.spins.difference > kOfAnotherScale
                  ? ", or with rates of another scale: they differ by " +
                        roundedText(100 * verdict.spins.difference, 2) +
                        " % from the attitudes' slopes"
                  : std::string());
    case Errs::TooFewAttitudes:
      return "can't be judged: its attitudes are too far apart for their slopes to be its angular "
             "velocities; record more of them, or the angular velocities, too";
    case Errs::TurnsMomentum:
      return "turns the angular momentum by " + roundedText(verdict.momentumTurnDeg, 3) +
             " degrees: another convention, another inertia, or an outer torque";
    case Errs::Swings:
      return "swings in energy or angular momentum, which come back: another inertia than that of "
             "the body that moved, or angular velocities with a bias, or of other moments than the "
             "attitudes";
    case Errs::GainsEnergy:
      return "keeps the angular momentum and gains energy, as explicit steps of the attitude do";
    case Errs::LosesEnergy:
      return "keeps the angular momentum and loses energy, as implicit steps do, or damping inside";
    case Errs::GainsMomentum:
      return "keeps the energy, and the angular momentum grows, as with velocities that are scaled "
             "to the energy";
    case Errs::LosesMomentum:
      return "keeps the energy, and the angular momentum falls, as with velocities that are scaled "
             "to the energy";
    case Errs::GainsBoth:
      return "gains energy, as with an explicit gyroscopic torque of order 1";
    case Errs::LosesBoth:
      return "loses energy and angular momentum, as with an implicit gyroscopic torque, or damping";
    case Errs::Inconsistently:
      return "loses energy while the angular momentum grows, as with a gyroscopic torque of order "
             "1 "
             "that doesn't fit the attitude's step";
  }
  return "";
}

}  // namespace rotatebook::timeline
