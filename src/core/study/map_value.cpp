#include "study/map_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "ensemble/ensemble.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "study/reduced.h"
#include "study/run_value.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::MapMeasure;
using scene::MapNumber;
using scene::Quantity;

/// Returns the angle of the body's line along its first spin to where that line was at the start.
/// [degrees]
double turnedDeg(const physics::Sample& sample, const physics::Sample& start) {
  const Eigen::Vector3d then = start.angularVelocity;  // both axes coincide at the start
  const Eigen::Vector3d now = sample.attitude * then;
  return arcTangent(then.cross(now).norm(), then.dot(now)) * 180 / std::numbers::pi;
}

/// Returns the value of one sample of a motion whose first one is `start`; `measure` isn't of the
/// way.
double valueOn(const physics::Sample& sample, const physics::Sample& start, MapMeasure measure) {
  if (const auto* quantity = std::get_if<Quantity>(&measure)) {
    return scene::valueOn(sample, start, *quantity);
  }
  if (measure == MapMeasure(MapNumber::EnergyDrift)) {
    return std::fabs(scene::valueOn(sample, start, Quantity::EnergyRatio) - 1);
  }
  return turnedDeg(sample, start);
}

std::vector<double> timesOf(double interval, double duration) {
  constexpr double kRounding = 1e-9;
  std::vector<double> times{0};
  for (std::int64_t n = 1;; ++n) {
    const double time = static_cast<double>(n) * interval;
    if (time >= duration * (1 - kRounding)) break;
    times.push_back(time);
  }
  times.push_back(duration);
  return times;
}

double flipIntervalOf(const MapRun& run, const MapPlan& plan, Stop stop) {
  std::vector<double> times = timesOf(run.interval, plan.duration);
  if (times.size() > 2) times.pop_back();  // flipTimes() takes even times
  Trajectory trajectory = simulate(run.motion, times, stop);
  if (trajectory.divergedAt) return kDiverged;
  trajectory.interval = run.interval;
  const double mean = physics::meanInterval(flipTimes(trajectory, modelInertia(run.motion)));
  return std::isnan(mean) ? kNever : mean;
}

double largestOf(const MapRun& run, const MapPlan& plan, Stop stop) {
  const Trajectory trajectory = simulate(run.motion, timesOf(run.interval, plan.duration), stop);
  if (trajectory.divergedAt) return kDiverged;
  if (const auto* quantity = std::get_if<Quantity>(&plan.measure)) {
    return reduced(trajectory, *quantity);
  }
  if (plan.is(MapNumber::EnergyDrift)) return reduced(trajectory, Quantity::EnergyRatio);
  double largest = 0;
  for (const physics::Sample& sample : trajectory.samples) {
    largest = std::max(largest, valueOn(sample, trajectory.samples.front(), plan.measure));
  }
  return largest;
}

double lastOf(const MotionSettings& motion, const MapPlan& plan) {
  return ValueOverTime(motion, plan.measure).at(plan.duration);
}

double valueOf(const MapRun& run, const MapPlan& plan, Stop stop) {
  try {
    if (plan.is(MapNumber::Growth)) return physics::tiltGrowth(modelInertia(run.motion));
    if (plan.is(MapNumber::FlipInterval)) return flipIntervalOf(run, plan, stop);
    if (plan.moment == scene::MapMoment::Largest) return largestOf(run, plan, stop);
    return lastOf(run.motion, plan);
  } catch (const InputError&) {  // StepError, too
  }
  return kRefused;
}

bool countsTurns(const MapPlan& plan) {
  return plan.is(Quantity::HalfTurns) || plan.is(Quantity::DivergesAt) ||
         plan.is(MapNumber::FirstFlip);
}

/// Looks at whole frames, so that no step is made in parts; at no more of them than anybody waits
/// for.
ensemble::WatchedMotion watchedMotion(const MapRun& run, double duration) {
  constexpr double kRounding = 1e-9;
  const auto framesIn = [](double frames) {
    return static_cast<std::int64_t>(std::clamp(std::floor(frames), 0.0, 1e15));
  };
  ensemble::WatchedMotion watched{run.motion};
  if (run.motion.simulation.model == physics::Model::Exact) {
    // It has no steps: a look is a frame.
    watched.frames = framesIn(std::ceil(duration / run.interval - kRounding));
    watched.motion.simulation.substepped = duration / static_cast<double>(watched.frames);
    return watched;
  }
  const double frame = run.motion.simulation.steps().time;
  watched.frames = framesIn(duration / frame + kRounding);
  watched.framesPerLook = std::max<std::int64_t>(framesIn(run.interval / frame + 0.5), 1);
  return watched;
}

double turnsOf(const ensemble::Outcome& outcome, const MapPlan& plan) {
  if (plan.is(MapNumber::FirstFlip) && outcome.firstTurn) return *outcome.firstTurn;
  if (outcome.isRefused) return kRefused;
  if (plan.is(Quantity::DivergesAt)) return outcome.divergedAt.value_or(kNever);
  if (outcome.divergedAt) return kDiverged;
  return plan.is(MapNumber::FirstFlip) ? kNever : outcome.halfTurns;
}

}  // namespace

ValueOverTime::ValueOverTime(const MotionSettings& motion, MapMeasure measure) : measure_(measure) {
  const auto is = [&](Quantity quantity) { return measure == MapMeasure(quantity); };
  const bool isOfExact = is(Quantity::ErrorDeg) || is(Quantity::Regime);
  if (motion.simulation.model == physics::Model::Exact && is(Quantity::TiltDeg)) {
    tilt_.emplace(motion);
  } else {
    simulation_.emplace(motion, isOfExact ? physics::Compared::WithExact : physics::Compared::No);
  }
}

double ValueOverTime::at(double time) {
  if (tilt_) return tilt_->degAt(time);
  const std::optional<physics::Sample> sample = simulation_->sampleOnce(time);
  if (!sample) return kDiverged;
  return valueOn(*sample, simulation_->trajectory().samples.front(), measure_);
}

std::vector<double> valuesOf(std::span<const MapRun> runs, const MapPlan& plan, Stop stop) {
  std::vector<double> values;
  if (!countsTurns(plan)) {
    for (const MapRun& run : runs)
      values.push_back(isSet(stop) ? kRefused : valueOf(run, plan, stop));
    return values;
  }
  std::vector<ensemble::WatchedMotion> watched;
  for (const MapRun& run : runs) watched.push_back(watchedMotion(run, plan.duration));
  for (const auto& outcome : ensemble::outcomesOf(watched, ensemble::widestSet(), stop)) {
    values.push_back(turnsOf(outcome, plan));
  }
  return values;
}

}  // namespace rotatebook::study
