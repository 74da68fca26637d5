#include "study/reduced.h"

#include <algorithm>
#include <cmath>

#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "scene/expectation.h"
#include "study/run_value.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::Measure;

double largestDeparture(const Trajectory& trajectory, Measure measure) {
  const scene::Expectation whole{.measure = measure};
  const scene::ExpectationResult range = scene::check(trajectory, {&whole, 1}).front();
  const double rest = scene::rowOf(measure).rest;
  return std::max(std::fabs(range.lowest - rest), std::fabs(range.highest - rest));
}

double firstFlip(const Trajectory& trajectory) {
  const auto flipped = std::ranges::find_if(
      trajectory.samples, [](const physics::Sample& sample) { return sample.halfTurns > 0; });
  return flipped == trajectory.samples.end() ? kNever : flipped->time;
}

double flipInterval(const Trajectory& trajectory, const MotionSettings& motion) {
  const double mean = physics::meanInterval(flipTimes(trajectory, modelInertia(motion)));
  return std::isnan(mean) ? kNever : mean;
}

double departureFromLaw(const Trajectory& trajectory, const MotionSettings& motion) {
  const double law =
      physics::asymptoticFlipInterval(modelInertia(motion), initialAngularVelocity(motion));
  return std::fabs(flipInterval(trajectory, motion) / law - 1);
}

}  // namespace

double reduced(const Trajectory& trajectory, const MotionSettings& motion, Measure measure) {
  switch (measure) {
    case Measure::Regime:
      return static_cast<double>(trajectory.samples.back().regime);
    case Measure::FirstFlip:
      return firstFlip(trajectory);
    case Measure::FlipInterval:
      return flipInterval(trajectory, motion);
    case Measure::FlipLaw:
      return departureFromLaw(trajectory, motion);
    case Measure::Growth:
      return physics::tiltGrowth(modelInertia(motion));
    case Measure::Order:
      return largestDeparture(trajectory, Measure::ErrorDeg);
    default:  // of each moment
      return largestDeparture(trajectory, measure);
  }
}

}  // namespace rotatebook::study
