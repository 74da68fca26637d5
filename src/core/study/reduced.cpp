#include "study/reduced.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::study {

double reduced(const physics::Trajectory& trajectory, scene::Measure measure) {
  if (measure == scene::Measure::Regime) {
    return static_cast<double>(trajectory.samples.back().regime);
  }
  const scene::Expectation whole{.measure = measure};
  const scene::ExpectationResult range = scene::check(trajectory, {&whole, 1}).front();
  const double rest = scene::rowOf(measure).rest;
  return std::max(std::fabs(range.lowest - rest), std::fabs(range.highest - rest));
}

}  // namespace rotatebook::study
