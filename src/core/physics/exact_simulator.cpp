#include "physics/exact_simulator.h"

#include "physics/motion_start.h"

namespace rotatebook::physics {

ExactSimulator::ExactSimulator(const MotionSettings& settings)
    : rotation_(exactRotation(settings)) {}

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
