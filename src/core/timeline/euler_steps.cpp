#include "timeline/euler_steps.h"

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
  return settings;
}

/// Returns whether L circles the axis of `regime` in every frame of the motion.
bool keeps(rigid::Regime regime, const physics::MotionSettings& settings, std::int64_t frames) {
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  const auto simulator = makeSimulator(settings);
  for (std::int64_t frame = 1; frame < frames; ++frame) {
    simulator->advance(settings.simulation.timePerFrame, settings.simulation.substeps);
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
  EulerSteps result;
  for (int substeps = 1; substeps <= kMaxSubsteps && substeps * frames <= kMaxSteps;
       substeps *= 2) {
    run.simulation.substeps = substeps;
    result.tried = substeps;
    result.step = settings.simulation.timePerFrame / substeps;
    if (!keeps(spin.regime, run, frames)) continue;
    result.substeps = substeps;
    break;
  }
  return result;
}

}  // namespace rotatebook::timeline
