#include "physics/motion_start.h"

#include "physics/particle_places.h"

namespace rotatebook::physics {

rigid::PrincipalAxes modelInertia(const MotionSettings& settings) {
  requireSameLayout();
  if (settings.simulation.model == Model::Particles) {
    if (settings.simulation.particles.arrangement == Arrangement::Corners)
      return {settings.body.particleInertia()};
    if (settings.particles.inertia) return settings.particles.inertia->axes();
    return rigid::principalAxes(particlesOf(settings).inertia(settings.body.mass));
  }
  if (settings.inertia) return settings.inertia->axes();
  return {settings.body.solidInertia()};
}

Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings) {
  return settings.initial.angularVelocity(modelInertia(settings));
}

NudgedRotation exactRotation(const MotionSettings& settings) {
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  return NudgedRotation({inertia, settings.initial.alongPrincipal(inertia),
                         inertia.angularMomentum(initialAngularVelocity(settings))},
                        settings.nudges);
}

}  // namespace rotatebook::physics
