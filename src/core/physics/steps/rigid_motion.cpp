#include "physics/steps/rigid_motion.h"

#include <algorithm>
#include <bit>

#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/integrator_table.h"
#include "physics/rigid_simulator.h"

namespace rotatebook::physics {
namespace {

bool isMomentumInBody(const AnyStep& step) {
  return std::visit([](const auto& one) { return one.kMomentumInBody; }, step);
}

std::optional<AnyStep> stepOf(const MotionSettings& settings, const RigidConstants& body) {
  const SimulationSettings& stepping = settings.simulation;
  if (!settings.nudges.empty() || stepping.dissipation != 0) return std::nullopt;
  const Stepping* found = steppingOf(stepping.model, stepping.integrator);
  if (found == nullptr) return std::nullopt;
  const auto make = stepping.model == Model::Matrix ? found->matrixStep : found->quaternionStep;
  if (make == nullptr) return std::nullopt;
  return make(body, stepping.steps().length());
}

template <typename State>
RigidMotion::State padded(const State& state) {
  using Numbers = std::array<double, sizeof(State) / sizeof(double)>;
  static_assert(sizeof(State) <= sizeof(RigidMotion::State));
  RigidMotion::State result{};
  std::ranges::copy(std::bit_cast<Numbers>(state), result.begin());
  return result;
}

// A step's state among padded numbers.
template <typename State>
State cut(const RigidMotion::State& padded) {
  std::array<double, sizeof(State) / sizeof(double)> numbers;
  std::copy_n(padded.begin(), numbers.size(), numbers.begin());
  return std::bit_cast<State>(numbers);
}

StepState<double> stateAt(const Eigen::Matrix3d& map, const Eigen::Vector3d& momentum,
                          const StepState<double>& /*type*/) {
  return {toNumbers(Eigen::Quaterniond(map)), toNumbers(momentum), {0, 0, 0}};
}

MatrixState<double> stateAt(const Eigen::Matrix3d& map, const Eigen::Vector3d& momentum,
                            const MatrixState<double>& /*type*/) {
  return {toColumns(map), toNumbers(momentum)};
}

}  // namespace

std::optional<RigidMotion> RigidMotion::of(const MotionSettings& settings) {
  requireSameLayout();
  const Model model = settings.simulation.model;
  if (model != Model::Quaternion && model != Model::Matrix) return std::nullopt;
  const rigid::PrincipalAxes axes = modelInertia(settings);
  const RigidConstants body = constantsOf(axes, settings.initial.angularVelocity(axes));
  const std::optional<AnyStep> step = stepOf(settings, body);
  if (!step) return std::nullopt;
  return RigidMotion(axes, body.momentum, *step);
}

std::optional<RigidMotion> RigidMotion::withStepsOf(const MotionSettings& settings) const {
  const RigidConstants body{axes_.moments, axes_.moments.cwiseInverse(), momentum_};
  const std::optional<AnyStep> step = stepOf(settings, body);
  if (!step) return std::nullopt;
  return RigidMotion(axes_, momentum_, *step);
}

RigidMotion::RigidMotion(const rigid::PrincipalAxes& axes, const Eigen::Vector3d& momentum,
                         const AnyStep& step)
    : axes_(axes), momentum_(momentum), step_(step) {}

RigidMotion::State RigidMotion::stateFrom(const Eigen::Matrix3d& map,
                                          const Eigen::Vector3d& momentum) const {
  return std::visit(
      [&](const auto& step) {
        return padded(stateAt(map, momentum, typename std::decay_t<decltype(step)>::State{}));
      },
      step_);
}

RigidMotion::State RigidMotion::start() const {
  const Eigen::Matrix3d& map = axes_.bodyFromPrincipal;
  return stateFrom(map, isMomentumInBody(step_) ? momentum_ : Eigen::Vector3d(map * momentum_));
}

RigidMotion::State RigidMotion::rest() const {
  return stateFrom(Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX());
}

BodyState RigidMotion::stateOf(const State& state) const {
  const RigidConstants body{axes_.moments, axes_.moments.cwiseInverse(), momentum_};
  return std::visit(
      [&](const auto& step) {
        const auto numbers = cut<typename std::decay_t<decltype(step)>::State>(state);
        const RigidState<decltype(toEigen(numbers.attitude))> rigid{toEigen(numbers.attitude),
                                                                    toEigen(numbers.momentum)};
        return bodyStateOf(body, axes_.bodyFromPrincipal.transpose(), rigid, step.kMomentumInBody);
      },
      step_);
}

}  // namespace rotatebook::physics
