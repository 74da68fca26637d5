#include "physics/exact_simulator.h"

namespace rotatebook::physics {

ExactRotation::ExactRotation(const PrincipalAxes& inertia, const Eigen::Vector3d& angularVelocity)
    : bodyFromPrincipal_(inertia.bodyFromPrincipal),
      motion_(inertia.moments, bodyFromPrincipal_.transpose() * angularVelocity) {}

ExactRotation::Moment ExactRotation::at(double time) const {
  const ExactMotion::Moment moment = motion_.at(time);
  // The world's axes are the body's at t = 0; the closed form's are the principal ones.
  const Eigen::Matrix3d worldFromPrincipal = bodyFromPrincipal_ * moment.worldFromBody;
  return {worldFromPrincipal * bodyFromPrincipal_.transpose(),
          worldFromPrincipal * moment.angularVelocityBody};
}

ExactSimulator::ExactSimulator(const MotionSettings& settings)
    : corners_(settings.body.corners()),
      angularMomentum_(modelInertia(settings).angularMomentum(initialAngularVelocity(settings))),
      rotation_(modelInertia(settings), initialAngularVelocity(settings)) {}

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
  result.corners = moment.worldFromBody * corners_;
  result.angularVelocity = moment.angularVelocity;
  result.angularMomentum = angularMomentum_;
  result.kinetic = moment.angularVelocity.dot(angularMomentum_) / 2;
  result.rotational = result.kinetic;
  return result;
}

}  // namespace rotatebook::physics
