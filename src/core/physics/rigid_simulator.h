// The paper's second and third models: a rigid body whose attitude is a matrix or a quaternion.
// Inside the room only.
#pragma once

#include <memory>

#include "physics/attitude.h"
#include "physics/integrators/rigid_state.h"
#include "physics/motion_settings.h"
#include "physics/motion_start.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Returns a rigid body's state at t = 0, when body and world axes coincide.
template <typename Attitude, bool kMomentumInBody>
RigidState<Attitude> startOf(const rigid::PrincipalAxes& axes, const Eigen::Vector3d& momentum) {
  const Eigen::Matrix3d& map = axes.bodyFromPrincipal;
  return {Attitude(map), kMomentumInBody ? momentum : Eigen::Vector3d(map * momentum)};
}

/// Returns a rigid body's constants, from the angular velocity at t = 0. [rad/s]
inline RigidConstants constantsOf(const rigid::PrincipalAxes& axes,
                                  const Eigen::Vector3d& angularVelocity) {
  const Eigen::Vector3d along = axes.bodyFromPrincipal.transpose() * angularVelocity;
  return {axes.moments, axes.moments.cwiseInverse(), axes.moments.cwiseProduct(along)};
}

/// Simulates a free rigid body whose attitude is an Eigen::Matrix3d or Eigen::Quaterniond. If
/// normalised, each step ends with the nearest attitude that is orthogonal or of unit norm. The
/// body is drawn by the map that the attitude represents, whether or not that is a rotation.
template <typename Attitude, RigidIntegrator Method>
class RigidSimulator final : public Simulator {
 public:
  explicit RigidSimulator(const MotionSettings& settings)
      : RigidSimulator(settings, modelInertia(settings)) {}

  void advance(double interval, int steps) override {
    const Method method(body_, interval / steps);
    RigidState<Attitude> state = state_;  // a copy that stays in registers
    for (int step = 0; step < steps; ++step) {
      method.step(state);
      if (normalize_) normalize(state.attitude);
    }
    state_ = state;
  }

  BodyState state() const override {
    const Eigen::Matrix3d map = mapOf(state_.attitude);
    const Eigen::Vector3d inBody = Method::kMomentumInBody
                                       ? state_.momentum
                                       : Eigen::Vector3d(map.transpose() * state_.momentum);
    const Eigen::Vector3d velocityInBody = body_.inverseInertia.cwiseProduct(inBody);
    BodyState result;
    result.worldFromBody = map * principalFromBody_;
    result.angularVelocity = map * velocityInBody;
    result.angularMomentum =
        Method::kMomentumInBody ? Eigen::Vector3d(map * inBody) : state_.momentum;
    result.kinetic = velocityInBody.dot(inBody) / 2;
    result.rotational = result.kinetic;
    return result;
  }

 private:
  RigidSimulator(const MotionSettings& settings, const rigid::PrincipalAxes& axes)
      : body_(constantsOf(axes, initialAngularVelocity(settings))),
        principalFromBody_(axes.bodyFromPrincipal.transpose()),
        state_(startOf<Attitude, Method::kMomentumInBody>(axes, body_.momentum)),
        normalize_(settings.simulation.normalize) {}

  RigidConstants body_;
  Eigen::Matrix3d principalFromBody_;
  RigidState<Attitude> state_;
  bool normalize_;
};

/// Creates the simulator for Model::Matrix or Model::Quaternion. Throws InputError as
/// makeSimulator() does.
template <RigidIntegrator Method>
std::unique_ptr<Simulator> makeRigidSimulator(const MotionSettings& settings) {
  if (settings.simulation.model == Model::Matrix) {
    return std::make_unique<RigidSimulator<Eigen::Matrix3d, Method>>(settings);
  }
  return std::make_unique<RigidSimulator<Eigen::Quaterniond, Method>>(settings);
}

}  // namespace rotatebook::physics
