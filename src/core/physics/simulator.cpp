#include "physics/simulator.h"

#include "physics/exact/exact_simulator.h"
#include "physics/integrators/integrator_table.h"

namespace rotatebook::physics {

PrincipalAxes modelInertia(const MotionSettings& settings) {
  const bool particles = settings.simulation.model == Model::Particles;
  if (!particles && settings.inertia) return principalAxes(*settings.inertia);
  return {particles ? settings.body.particleInertia() : settings.body.solidInertia()};
}

Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings) {
  return settings.initial.angularVelocity(modelInertia(settings));
}

std::unique_ptr<Simulator> makeSimulator(const MotionSettings& settings) {
  if (settings.simulation.model == Model::Exact) return std::make_unique<ExactSimulator>(settings);
  const Stepping* stepping = steppingOf(settings.simulation.model, settings.simulation.integrator);
  if (stepping == nullptr) throw InputError("this model doesn't have this integrator");
  return stepping->make(settings);
}

}  // namespace rotatebook::physics
