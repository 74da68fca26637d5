#include "physics/exact_simulator.h"

#include "physics/motion_start.h"

namespace rotatebook::physics {

ExactSimulator::ExactSimulator(const MotionSettings& settings)
    : rotation_(exactRotation(settings)) {}

void ExactSimulator::advance(double interval, int /*steps*/) {
  if (interval != interval_) {
    start_ = time();
    interval_ = interval;
    count_ = 0;
  }
  ++count_;
}

BodyState ExactSimulator::state() const {
  const NudgedRotation::Moment moment = rotation_.at(time());
  BodyState result;
  result.worldFromBody = moment.worldFromBody;
  result.angularVelocity = moment.angularVelocity;
  result.angularMomentum = moment.angularMomentum;
  result.kinetic = moment.angularVelocity.dot(moment.angularMomentum) / 2;
  result.rotational = result.kinetic;
  return result;
}

}  // namespace rotatebook::physics
