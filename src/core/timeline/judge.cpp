#include "timeline/judge.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/measure/measurement.h"
#include "physics/motion_start.h"
#include "physics/recorded_start.h"
#include "physics/simulate.h"
#include "recording/attitudes_alone.h"
#include "rigid/regime.h"
#include "timeline/exact_comparison.h"
#include "timeline/fitted_start.h"

namespace rotatebook::timeline {
namespace {

using physics::MotionSettings;
using physics::Sample;

constexpr double kDegreesInRadian = 180 / std::numbers::pi;

/// Returns the largest change of the angular velocity in the world, relative to the first.
double spinChange(std::span<const Sample> samples) {
  const Eigen::Vector3d& start = samples.front().angularVelocity;
  double largest = 0;
  for (const Sample& sample : samples)
    largest = std::max(largest, (sample.angularVelocity - start).norm() / start.norm());
  return largest;
}

/// Returns the means of the spins and of L over so many samples each.
std::vector<Sample> meansOf(std::span<const Sample> samples, std::size_t count) {
  std::vector<Sample> means;
  for (; samples.size() >= count; samples = samples.subspan(count)) {
    Sample& mean = means.emplace_back();
    for (const Sample& sample : samples.first(count)) {
      mean.angularVelocity += sample.angularVelocity / static_cast<double>(count);
      mean.angularMomentum += sample.angularMomentum / static_cast<double>(count);
    }
  }
  return means;
}

/// Returns the largest angle from L to the exact motion's, by means over so many samples; with
/// noise, to that of the first. [degrees]
double turnDegOf(const std::vector<Sample>& means, const std::vector<Sample>& exact,
                 std::size_t count) {
  const bool isNoisy = count > 1;
  const std::vector<Sample> first(means.size(), means.front());
  return std::ranges::max(compared(means, isNoisy ? first : exact).turnDeg);
}

/// Returns the angle that L may turn by without a reason. [degrees]
double turnBoundDeg(const Changes& changes) {
  return 2 * kAgreesDeg + changes.ofASample * kDegreesInRadian;
}

/// Returns whether as many half-turns are made as are due, or one is just being made at the start
/// or the end, to a tilt within what L may turn by.
bool makesDueHalfTurns(const Verdict& verdict, const Changes& changes,
                       const std::vector<Sample>& samples) {
  const int made = verdict.halfTurns, due = verdict.halfTurnsDue;
  const bool isOneOff = made == due + 1 || made + 1 == due;
  const auto isAtLimit = [&](const Sample& sample) {
    const double fromLimit = std::min(std::fabs(sample.tiltDeg - physics::kNearTiltDeg),
                                      std::fabs(sample.tiltDeg - physics::kFarTiltDeg));
    return fromLimit < turnBoundDeg(changes);
  };
  return made == due || (isOneOff && (isAtLimit(samples.front()) || isAtLimit(samples.back())));
}

/// Returns whether all is the exact motion's, to `noiseDeg` of the attitudes.
bool agrees(const Verdict& verdict, const Changes& changes, const std::vector<Sample>& samples,
            double noiseDeg) {
  constexpr double kSigmas = 5;
  return verdict.errorDeg < kAgreesDeg + kSigmas * noiseDeg && changes.keepEnergy() &&
         changes.keepMomentum() && verdict.momentumTurnDeg < turnBoundDeg(changes) &&
         makesDueHalfTurns(verdict, changes, samples);
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
            const std::vector<Sample>& exact, double noiseDeg) {
  if (agrees(verdict, changes, samples, noiseDeg)) return Errs::Hardly;
  // A spin that the exact motion keeps, too, tells nothing.
  constexpr double kMoves = 0.02, kClearly = 4;
  const auto motions = inner(samples, verdict), exactOnes = inner(exact, verdict);
  const std::size_t count = samplesAMean(changes.scatter(), motions.size());
  const std::vector<Sample> means = meansOf(motions, count), exactMeans = meansOf(exactOnes, count);
  const double spinBound = std::max(changes.energyBound, changes.momentumBound);
  if (spinChange(means) < spinBound &&
      spinChange(exactMeans) > std::max(kMoves, kClearly * spinBound))
    return Errs::SpinIsFixed;
  // Exact motions have 0.012 at 10 attitudes a turn, and 0.046 at 5, measured.
  constexpr double kTooUncertain = 0.025;
  if (verdict.spins.uncertainty > kTooUncertain) return Errs::TooFewAttitudes;
  const bool keepsBoth = changes.keepEnergy() && changes.keepMomentum();
  if (keepsBoth && verdict.errorDeg < verdict.spins.unknownTurn * kDegreesInRadian)
    return Errs::TooFewReadings;
  const std::optional<Errs> trend = keepsBoth ? std::nullopt : trendOf(changes);
  // Steps that make L much larger or smaller turn it on the way.
  const double turnDeg = turnDegOf(means, exactMeans, count);
  const bool turns = turnDeg > kTurnsDeg;
  if (turns && !(trend && changes.momentum.range > turnDeg / kDegreesInRadian))
    return Errs::TurnsMomentum;
  if (trend) return *trend;
  if (verdict.errorDeg < kAgreesDeg) {
    // Slopes over a gap are no spins that were measured.
    const bool areSlopes = verdict.spins.source == recording::SpinSource::Slopes;
    return areSlopes ? Errs::Hardly : Errs::SpinsAreOthers;
  }
  if (!keepsBoth) return Errs::Swings;
  // Steps that keep both keep the direction of L, too.
  return turnDeg < turnBoundDeg(changes) ? Errs::InPhase : Errs::TurnsSlightly;
}

/// Returns whether the exact motion may be fitted: that of a recording whose spins aren't exact.
bool mayFit(const MotionSettings& motion, const Verdict& verdict) {
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

/// Returns the exact motion from a start that is fitted, at the times of `samples`.
std::vector<Sample> exactFrom(const FittedStart& start, MotionSettings motion,
                              const std::vector<Sample>& samples) {
  motion.initial.value = start.angularVelocity;
  std::vector<Sample> exact = exactAt(std::move(motion), samples);
  for (Sample& sample : exact) {
    sample.attitude = start.attitude * sample.attitude;
    sample.angularMomentum = start.attitude * sample.angularMomentum;
  }
  return exact;
}

/// Returns the relative change of the start's spin by a fit.
double changeBy(const FittedStart& start, const MotionSettings& motion) {
  return (start.angularVelocity - motion.initial.value).norm() / motion.initial.value.norm();
}

/// Returns the verdict if the motion agrees with the exact one from this start.
std::optional<Verdict> fitted(const FittedStart& start, const MotionSettings& motion,
                              const std::vector<Sample>& samples, Verdict verdict) {
  verdict.fittedBy = changeBy(start, motion);
  if (*verdict.fittedBy > largestFit(verdict)) return std::nullopt;
  const std::vector<Sample> exact = exactFrom(start, motion, samples);
  Comparison comparison = compared(samples, exact);
  const double noiseDeg = setErrors(comparison, samples, exact);
  takeMeasures(comparison, exact, verdict);
  verdict.errs = Errs::HardlyAsFitted;
  if (!agrees(verdict, changesIn(comparison, verdict), samples, noiseDeg)) return std::nullopt;
  return verdict;
}

/// Returns the regime of the motion from this start.
rigid::Regime regimeFrom(const FittedStart& start, const rigid::PrincipalAxes& inertia) {
  return rigid::regimeOf(inertia.moments,
                         inertia.bodyFromPrincipal.transpose() * start.angularVelocity);
}

/// Refines the verdict on a motion whose spins are uncertain by fits.
Verdict refined(const Verdict& verdict, const MotionSettings& motion,
                const std::vector<Sample>& samples) {
  const rigid::PrincipalAxes inertia = physics::modelInertia(motion);
  const FittedStart start = fitStart(inertia, samples);
  Verdict result = verdict;
  if (verdict.errs != Errs::Hardly)
    result = fitted(start, motion, samples, verdict).value_or(verdict);
  if (agreesWithExact(result)) {
    result.start = result.end = regimeFrom(start, inertia);
    return result;
  }
  // Half a turn tells the spin; in a whole one, wrong steps leave the exact motion by more.
  constexpr double kWhole = 2 * std::numbers::pi;
  result.start = regimeFrom(fitFirst(inertia, samples, kWhole), inertia);
  result.end = regimeFrom(fitLast(inertia, samples, kWhole), inertia);
  const FittedStart first = fitFirst(inertia, samples, kWhole / 2);
  if (changeBy(first, motion) < largestFit(verdict))
    result.halfTurnsDue = exactFrom(first, motion, samples).back().halfTurns;
  return result;
}

/// Returns the verdict by the spins as they are.
Verdict verdictOn(const MotionSettings& motion, const std::vector<Sample>& samples) {
  Verdict verdict;
  verdict.samples = samples.size();
  verdict.duration = samples.back().time;
  verdict.halfTurns = samples.back().halfTurns;
  verdict.start = samples.front().regime;
  verdict.end = samples.back().regime;
  const bool isRecorded = motion.simulation.model == physics::Model::Recorded;
  verdict.isRecorded = isRecorded;
  if (isRecorded) verdict.spins = motion.simulation.recorded.motion->spins();
  const std::vector<Sample> exact = exactAt(motion, samples);
  Comparison comparison = compared(samples, exact);
  relateToFirst(comparison, verdict);
  takeMeasures(comparison, exact, verdict);
  const Changes changes = changesIn(comparison, verdict);
  verdict.scatter = changes.scatter();
  const double noiseDeg = isRecorded ? setErrors(comparison, samples, exact) : 0;
  verdict.errs = errsOf(verdict, changes, samples, exact, noiseDeg);
  return mayFit(motion, verdict) ? refined(verdict, motion, samples) : verdict;
}

/// A recorded motion, and what is measured of it.
struct Recorded {
  MotionSettings motion;
  std::vector<Sample> samples;
};

/// Returns another recording in the place of `motion`'s, up to a time; nothing of a body at rest.
std::optional<Recorded> inPlace(MotionSettings motion, const recording::RecordedMotion& other,
                                double until) {
  std::vector<double> times;
  for (const recording::RecordedMoment& moment : other.moments()) {
    if (moment.time <= until) times.push_back(moment.time);
  }
  if (times.size() < kLeastRows || other.moments().front().angularVelocity.isZero(0))
    return std::nullopt;
  physics::takeRecording(motion, std::make_shared<recording::RecordedMotion>(other), "");
  return Recorded{motion, physics::simulate(motion, times).samples};
}

/// Returns whether steps of a row's length may make the rates that multiple of the slopes: the
/// midpoint rule makes 1 + (h w)^2 / 12.
bool mayBeOfSteps(const recording::SpinFacts& spins, const std::vector<Sample>& samples) {
  constexpr double kOfMidpoint = 1.0 / 12, kMargin = 1.5;
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = samples[i].time - samples[i - 1].time;
    sum += step * step * samples[i].angularVelocity.squaredNorm();
  }
  const double mean = sum / static_cast<double>(samples.size() - 1);
  const double largest = kMargin * kOfMidpoint * mean;
  return spins.fit.bias.isZero(0) && spins.fit.turn.isZero(0) &&
         std::fabs(spins.fit.factor - 1) < largest && spins.difference < 2 * largest;
}

/// Returns the verdict on a recording, whose rates aren't held against attitudes that agree alone.
Verdict verdictOnRecorded(const Recorded& recorded) {
  const auto& [motion, samples] = recorded;
  const Verdict verdict = verdictOn(motion, samples);
  const recording::SpinFacts& spins = verdict.spins;
  const bool areGiven = spins.source == recording::SpinSource::Given;
  const bool areSteps = verdict.errs == Errs::InPhase && mayBeOfSteps(spins, samples);
  if (agreesWithExact(verdict) || !areGiven || areSteps || !motion.nudges.empty()) return verdict;
  const auto alone = inPlace(motion, recording::attitudesAlone(*motion.simulation.recorded.motion),
                             samples.back().time);
  if (!alone) return verdict;
  Verdict result = verdictOn(alone->motion, alone->samples);
  if (!agreesWithExact(result)) return verdict;
  result.spins = spins;
  result.errs = Errs::RatesAreOff;
  return result;
}

}  // namespace

Verdict judge(const MotionSettings& motion, const physics::Trajectory& trajectory) {
  const std::vector<Sample>& samples = trajectory.samples;
  if (motion.simulation.model != physics::Model::Recorded) return verdictOn(motion, samples);
  const recording::RecordedMotion& recording = *motion.simulation.recorded.motion;
  if (std::min(recording.moments().size(), samples.size()) < kLeastRows)
    return {.samples = samples.size(), .duration = samples.back().time, .errs = Errs::TooFewRows};
  const auto sound = recording.sound() != nullptr && motion.nudges.empty()
                         ? inPlace(motion, *recording.sound(), samples.back().time)
                         : std::nullopt;
  if (!sound) return verdictOnRecorded({motion, samples});
  Verdict verdict = verdictOnRecorded(*sound);
  verdict.flaws = recording.flaws();
  verdict.errorDeg = std::max(verdict.errorDeg, recording.largestStray() * kDegreesInRadian);
  return verdict;
}

}  // namespace rotatebook::timeline
