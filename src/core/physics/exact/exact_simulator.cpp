#include "physics/exact/exact_simulator.h"

#include "physics/motion_start.h"

namespace rotatebook::physics {

ExactSimulator::ExactSimulator(const MotionSettings& settings)
    : angularMomentum_(modelInertia(settings).angularMomentum(initialAngularVelocity(settings))),
      rotation_(modelInertia(settings), settings.initial.alongPrincipal(modelInertia(settings))) {}

void ExactSimulator::advance(double h, int steps) {
  if (h != h_) {
    start_ = time();
    h_ = h;
    steps_ = 0;
  }
  steps_ += steps;
}

BodyState ExactSimulator::state() const {
  const ExactRotation::Moment moment = rotation_.at(time());
  BodyState result;
  result.worldFromBody = moment.worldFromBody;
  result.angularVelocity = moment.angularVelocity;
  result.angularMomentum = angularMomentum_;
  result.kinetic = moment.angularVelocity.dot(angularMomentum_) / 2;
  result.rotational = result.kinetic;
  return result;
}

}  // namespace rotatebook::physics
