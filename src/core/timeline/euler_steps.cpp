#include "timeline/euler_steps.h"

#include <algorithm>
#include <cmath>

#include "physics/make_simulator.h"
#include "physics/motion_start.h"
#include "timeline/spin.h"

namespace rotatebook::timeline {
namespace {

constexpr int kMaxSubsteps = 1 << 19;
constexpr std::int64_t kMaxSteps = 1 << 26;

/// Returns the settings of the rigid body that explicit Euler is to simulate.
physics::MotionSettings byEuler(physics::MotionSettings settings) {
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  const bool isParticles = settings.simulation.model == physics::Model::Particles;
  if (isParticles) {
    const Eigen::Matrix3d& axes = inertia.bodyFromPrincipal;
    settings.inertia = axes * inertia.moments.asDiagonal() * axes.transpose();
  }
  settings.simulation.model = physics::Model::Quaternion;
  settings.simulation.integrator = physics::Integrator::Euler;
  settings.simulation.normalizeEvery = 1;
  settings.simulation.dissipation = 0;
  settings.simulation.step.reset();
  return settings;
}

/// Returns the runs of EqualSteps that samples of so many frames take, and one more.
std::int64_t runsOf(const physics::SimulationSettings& settings, std::int64_t frames) {
  constexpr double kRounding = 1e-9, kMany = 1e15;
  const double length = static_cast<double>(frames - 1) * settings.timePerFrame;
  const double runs = std::ceil(length / settings.steps().time * (1 - kRounding));
  return 1 + static_cast<std::int64_t>(std::min(runs, kMany));
}

/// Returns whether L circles the axis of `regime` after every run of EqualSteps.
bool keeps(rigid::Regime regime, const physics::MotionSettings& settings, std::int64_t runs) {
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  const auto simulator = makeSimulator(settings);
  const physics::EqualSteps steps = settings.simulation.steps();
  for (std::int64_t run = 1; run < runs; ++run) {
    simulator->advance(steps.time, steps.count);
    const physics::BodyState state = simulator->state();
    const Eigen::Vector3d inBody = state.worldFromBody.transpose() * state.angularVelocity;
    const Eigen::Vector3d along = inertia.bodyFromPrincipal.transpose() * inBody;
    if (!along.allFinite() || rigid::regimeOf(inertia.moments, along) != regime) return false;
  }
  return true;
}

}  // namespace

std::optional<EulerSteps> eulerStepsFor(const physics::MotionSettings& settings,
                                        std::int64_t frames) {
  const Spin spin = spinOf(settings);
  if (frames < 2 || !spin.period || spin.equal != EqualMoments::None) return std::nullopt;
  physics::MotionSettings run = byEuler(settings);
  const std::int64_t runs = runsOf(run.simulation, frames);
  if (runs > kMaxSteps) return std::nullopt;
  EulerSteps result;
  for (int substeps = 1; substeps <= kMaxSubsteps && substeps * runs <= kMaxSteps; substeps *= 2) {
    run.simulation.substeps = substeps;
    result.tried = substeps;
    result.step = run.simulation.steps().length();
    if (!keeps(spin.regime, run, runs)) continue;
    result.substeps = substeps;
    break;
  }
  return result;
}

}  // namespace rotatebook::timeline
