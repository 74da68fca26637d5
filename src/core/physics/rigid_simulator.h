// The paper's second and third models: a rigid body whose attitude is a matrix or a quaternion.
// Inside the room only.
#pragma once

#include <memory>

#include "physics/attitude.h"
#include "physics/cadence.h"
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
                                  const Eigen::Vector3d& angularVelocity, double dissipation = 0) {
  const Eigen::Vector3d along = axes.bodyFromPrincipal.transpose() * angularVelocity;
  return {axes.moments, axes.moments.cwiseInverse(), axes.moments.cwiseProduct(along), dissipation};
}

/// Returns the state as it is reported, with the momentum in these axes. The angular velocity is
/// I^-1 L, from which turnRate() differs by eps I^-1 a.
template <typename Attitude>
BodyState bodyStateOf(const RigidConstants& body, const Eigen::Matrix3d& principalFromBody,
                      const RigidState<Attitude>& state, bool momentumInBody) {
  const Eigen::Matrix3d map = mapOf(state.attitude);
  const Eigen::Vector3d inBody =
      momentumInBody ? state.momentum : Eigen::Vector3d(map.transpose() * state.momentum);
  const Eigen::Vector3d velocityInBody = body.inverseInertia.cwiseProduct(inBody);
  BodyState result;
  result.worldFromBody = map * principalFromBody;
  result.angularVelocity = map * velocityInBody;
  result.angularMomentum = momentumInBody ? Eigen::Vector3d(map * inBody) : state.momentum;
  result.kinetic = velocityInBody.dot(inBody) / 2;
  result.rotational = result.kinetic;
  return result;
}

/// Simulates a free rigid body whose attitude is an Eigen::Matrix3d or Eigen::Quaterniond. A
/// step after which a normalisation is due ends with the nearest attitude that is orthogonal or of
/// unit norm. The body is drawn by the map that the attitude represents, whether or not that is a
/// rotation.
template <typename Attitude, RigidIntegrator Method>
class RigidSimulator final : public Simulator {
 public:
  explicit RigidSimulator(const MotionSettings& settings)
      : RigidSimulator(settings, modelInertia(settings)) {}

  void advance(double interval, int steps) override {
    const Method method(body_, interval / steps);
    // Copies that stay in registers.
    RigidState<Attitude> state = state_;
    Cadence normalization = normalization_;
    for (int step = 0; step < steps; ++step) {
      method.step(state);
      if (normalization.isDue()) normalize(state.attitude);
    }
    state_ = state;
    normalization_ = normalization;
  }

  void advancePart(double part) override { Method(body_, part).step(state_); }

  void nudge(const Nudge& nudge) override {
    const Eigen::Matrix3d map = mapOf(state_.attitude);
    const bool isInBody = nudge.axes == Nudge::Axes::Body;
    const Eigen::Vector3d along =
        (isInBody ? principalFromBody_ : Eigen::Matrix3d(map.transpose())) * nudge.value;
    const bool isVelocity = nudge.kind == SpinKind::AngularVelocity;
    const Eigen::Vector3d change = isVelocity ? body_.inertia.cwiseProduct(along) : along;
    state_.momentum += Method::kMomentumInBody ? change : Eigen::Vector3d(map * change);
    body_.momentum = Method::kMomentumInBody ? state_.momentum
                                             : Eigen::Vector3d(map.transpose() * state_.momentum);
  }

  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<RigidSimulator>(*this);
  }
  BodyState state() const override {
    return bodyStateOf(body_, principalFromBody_, state_, Method::kMomentumInBody);
  }

 private:
  RigidSimulator(const MotionSettings& settings, const rigid::PrincipalAxes& axes)
      : body_(constantsOf(axes, initialAngularVelocity(settings), settings.simulation.dissipation)),
        principalFromBody_(axes.bodyFromPrincipal.transpose()),
        state_(startOf<Attitude, Method::kMomentumInBody>(axes, body_.momentum)),
        normalization_(settings.simulation.normalizeEvery) {}

  RigidConstants body_;
  Eigen::Matrix3d principalFromBody_;
  RigidState<Attitude> state_;
  Cadence normalization_;
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
