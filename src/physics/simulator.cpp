#include "physics/simulator.h"

#include "physics/matrix_simulator.h"
#include "physics/particle_simulator.h"
#include "physics/quaternion_simulator.h"

namespace rotatebook::physics {

Eigen::Vector3d modelInertia(const MotionSettings& settings) {
  const bool particles = settings.simulation.model == Model::Particles;
  return particles ? settings.body.particleInertia() : settings.body.solidInertia();
}

Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings) {
  return settings.initial.angularVelocity(modelInertia(settings));
}

std::unique_ptr<Simulator> makeSimulator(const MotionSettings& settings) {
  switch (settings.simulation.model) {
    case Model::Particles:
      return std::make_unique<ParticleSimulator>(settings);
    case Model::Matrix:
      return std::make_unique<MatrixSimulator>(settings);
    case Model::Quaternion:
      break;
  }
  return std::make_unique<QuaternionSimulator>(settings);
}

}  // namespace rotatebook::physics
