#include "study/reduced.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::study {

double reduced(const physics::Trajectory& trajectory, scene::Quantity quantity) {
  if (quantity == scene::Quantity::Regime) {
    return static_cast<double>(trajectory.samples.back().regime);
  }
  const scene::Expectation whole{.quantity = quantity};
  const scene::ExpectationResult range = scene::check(trajectory, {&whole, 1}).front();
  const double rest = scene::restOf(quantity);
  return std::max(std::fabs(range.lowest - rest), std::fabs(range.highest - rest));
}

}  // namespace rotatebook::study
