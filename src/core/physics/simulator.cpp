#include "physics/simulator.h"

#include "physics/exact/exact_simulator.h"
#include "physics/particle_simulator.h"
#include "physics/rigid_simulator.h"

namespace rotatebook::physics {
namespace {

void checkIntegrator(const SimulationSettings& settings) {
  if (settings.model == Model::Exact || isFor(settings.model, settings.integrator)) return;
  throw InputError("this model doesn't have this integrator");
}

}  // namespace

PrincipalAxes modelInertia(const MotionSettings& settings) {
  const bool particles = settings.simulation.model == Model::Particles;
  if (!particles && settings.inertia) return principalAxes(*settings.inertia);
  return {particles ? settings.body.particleInertia() : settings.body.solidInertia()};
}

Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings) {
  return settings.initial.angularVelocity(modelInertia(settings));
}

std::unique_ptr<Simulator> makeSimulator(const MotionSettings& settings) {
  checkIntegrator(settings.simulation);
  switch (settings.simulation.model) {
    case Model::Particles:
      return std::make_unique<ParticleSimulator>(settings);
    case Model::Exact:
      return std::make_unique<ExactSimulator>(settings);
    case Model::Matrix:
    case Model::Quaternion:
      break;
  }
  return makeRigidSimulator(settings);
}

}  // namespace rotatebook::physics
