#include "physics/motion_start.h"

namespace rotatebook::physics {

rigid::PrincipalAxes modelInertia(const MotionSettings& settings) {
  requireSameLayout();
  const bool particles = settings.simulation.model == Model::Particles;
  if (!particles && settings.inertia) return rigid::principalAxes(*settings.inertia);
  return {particles ? settings.body.particleInertia() : settings.body.solidInertia()};
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
