#include "physics/steps/quaternion_motion.h"

#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/integrator_table.h"
#include "physics/rigid_simulator.h"

namespace rotatebook::physics {
namespace {

bool isMomentumInBody(const AnyStep& step) {
  return std::visit([](const auto& one) { return one.kMomentumInBody; }, step);
}

}  // namespace

std::optional<QuaternionMotion> QuaternionMotion::of(const MotionSettings& settings) {
  requireSameLayout();
  const SimulationSettings& stepping = settings.simulation;
  if (stepping.model != Model::Quaternion || !settings.nudges.empty()) return std::nullopt;
  if (stepping.dissipation != 0) return std::nullopt;
  const Stepping* found = steppingOf(stepping.model, stepping.integrator);
  if (found == nullptr || found->quaternionStep == nullptr) return std::nullopt;
  const rigid::PrincipalAxes axes = modelInertia(settings);
  const RigidConstants body = constantsOf(axes, settings.initial.angularVelocity(axes));
  const double h = stepping.steps().length();
  return QuaternionMotion(axes, body.momentum, found->quaternionStep(body, h));
}

QuaternionMotion::QuaternionMotion(const rigid::PrincipalAxes& axes,
                                   const Eigen::Vector3d& momentum, const AnyStep& step)
    : axes_(axes), momentum_(momentum), step_(step) {}

StepState<double> QuaternionMotion::start() const {
  const auto state = isMomentumInBody(step_) ? startOf<Eigen::Quaterniond, true>(axes_, momentum_)
                                             : startOf<Eigen::Quaterniond, false>(axes_, momentum_);
  const Eigen::Quaterniond& q = state.attitude;
  return {{q.w(), q.x(), q.y(), q.z()}, toNumbers(state.momentum), {0, 0, 0}};
}

BodyState QuaternionMotion::stateOf(const StepState<double>& state) const {
  const RigidConstants body{axes_.moments, axes_.moments.cwiseInverse(), momentum_};
  return bodyStateOf(
      body, axes_.bodyFromPrincipal.transpose(),
      RigidState<Eigen::Quaterniond>{toEigen(state.attitude), toEigen(state.momentum)},
      isMomentumInBody(step_));
}

}  // namespace rotatebook::physics
