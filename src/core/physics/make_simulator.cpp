#include "physics/make_simulator.h"

#include "base/error.h"
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
