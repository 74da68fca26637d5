#include "study/map_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "study/reduced.h"
#include "study/run_value.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::Measure;

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
  return reduced(trajectory, run.motion, plan.measure);
}

double largestOf(const MapRun& run, const MapPlan& plan, Stop stop) {
  const Trajectory trajectory = simulate(run.motion, timesOf(run.interval, plan.duration), stop);
  if (trajectory.divergedAt) return kDiverged;
  return reduced(trajectory, run.motion, plan.measure);
}

double lastOf(const MotionSettings& motion, const MapPlan& plan) {
  return ValueOverTime(motion, plan.measure).at(plan.duration);
}

/// Returns the value of a run whose turns needn't be counted.
double measured(const MapRun& run, const MapPlan& plan, Stop stop) {
  if (plan.is(Measure::Growth)) return physics::tiltGrowth(modelInertia(run.motion));
  if (plan.is(Measure::FlipInterval) || plan.is(Measure::FlipLaw))
    return flipIntervalOf(run, plan, stop);
  if (plan.moment == scene::MapMoment::Largest) return largestOf(run, plan, stop);
  return lastOf(run.motion, plan);
}

double valueOf(const MapRun& run, const MapPlan& plan, Stop stop) {
  try {
    return measured(run, plan, stop);
  } catch (const InputError&) {  // StepError, too
  }
  return kRefused;
}

bool countsTurns(const MapPlan& plan) {
  return plan.is(Measure::HalfTurns) || plan.is(Measure::DivergesAt) || plan.is(Measure::FirstFlip);
}

/// Looks at whole frames, so that no step is made in parts; at no more of them than anybody waits
/// for.
void watch(const MapRun& run, double duration, lanes::WatchedMotion& watched) {
  constexpr double kRounding = 1e-9;
  const auto framesIn = [](double frames) {
    return static_cast<std::int64_t>(std::clamp(std::floor(frames), 0.0, 1e15));
  };
  watched.motion = run.motion;
  if (run.motion.simulation.model == physics::Model::Exact) {
    // It has no steps: a look is a frame.
    watched.frames = framesIn(std::ceil(duration / run.interval - kRounding));
    watched.framesPerLook = 1;
    watched.motion.simulation.substepped = duration / static_cast<double>(watched.frames);
    return;
  }
  const double frame = run.motion.simulation.steps().time;
  watched.frames = framesIn(duration / frame + kRounding);
  watched.framesPerLook = std::max<std::int64_t>(framesIn(run.interval / frame + 0.5), 1);
}

double turnsOf(const lanes::Outcome& outcome, const MapPlan& plan) {
  if (plan.is(Measure::FirstFlip) && outcome.firstTurn) return *outcome.firstTurn;
  if (outcome.isRefused) return kRefused;
  if (plan.is(Measure::DivergesAt)) return outcome.divergedAt.value_or(kNever);
  if (outcome.divergedAt) return kDiverged;
  return plan.is(Measure::FirstFlip) ? kNever : outcome.halfTurns;
}

}  // namespace

ValueOverTime::ValueOverTime(const MotionSettings& motion, Measure measure) : measure_(measure) {
  const auto is = [&](Measure one) { return measure == one; };
  const bool isOfExact = is(Measure::ErrorDeg) || is(Measure::Regime);
  if (motion.simulation.model == physics::Model::Exact && is(Measure::TiltDeg)) {
    tilt_.emplace(motion);
  } else {
    simulation_.emplace(motion, isOfExact ? physics::Compared::WithExact : physics::Compared::No);
  }
}

double ValueOverTime::at(double time) {
  if (tilt_) return tilt_->degAt(time);
  const std::optional<physics::Sample> sample = simulation_->sampleOnce(time);
  if (!sample) return kDiverged;
  return scene::valueOn(*sample, simulation_->trajectory().samples.front(), measure_);
}

MapValues::MapValues(const MapPlan& plan, Stop stop)
    : plan_(plan), stop_(stop), ensemble_(lanes::widestSet(), stop) {}

std::size_t MapValues::add(const MapRun& run) {
  if (countsTurns(plan_)) {
    watch(run, plan_.duration, watched_);
    ensemble_.add(watched_);
  } else {
    values_.push_back(isSet(stop_) ? kRefused : valueOf(run, plan_, stop_));
  }
  return count_++;
}

std::vector<double> MapValues::finish() {
  for (const lanes::Outcome& outcome : ensemble_.finish())
    values_.push_back(turnsOf(outcome, plan_));
  return values_;
}

}  // namespace rotatebook::study
