#include "physics/motion_start.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "physics/particle_places.h"
#include "rigid/rotation.h"

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

void takeInertia(MotionSettings& settings, const Eigen::Matrix3d& tensor) {
  settings.inertia = rigid::checkedInertia(tensor);
}

Eigen::Vector3d initialAngularVelocity(const MotionSettings& settings) {
  return settings.initial.angularVelocity(modelInertia(settings));
}

std::optional<Eigen::Matrix3d> initialAttitude(const InitialSpin& initial) {
  if (!initial.attitude) return std::nullopt;
  const Eigen::Vector4d q = *initial.attitude / initial.attitude->stableNorm();
  return rigid::unnormalisedMatrix(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
}

MotionSettings withoutAttitude(MotionSettings settings) {
  const auto attitude = initialAttitude(settings.initial);
  if (!attitude) return settings;
  settings.initial.attitude.reset();
  for (Nudge& nudge : settings.nudges)
    if (nudge.axes == Nudge::Axes::World) nudge.value = attitude->transpose() * nudge.value;
  return settings;
}

double fastestDissipation(const MotionSettings& settings) {
  if (!settings.simulation.dissipates()) return 0;
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  Eigen::Vector3d moments = inertia.moments;
  std::sort(moments.begin(), moments.end());
  double momentum = inertia.angularMomentum(initialAngularVelocity(settings)).stableNorm();
  for (const Nudge& nudge : settings.nudges) {
    const bool isMomentum = nudge.kind == SpinKind::AngularMomentum;
    momentum += (isMomentum ? 1 : moments[2]) * nudge.value.stableNorm();
  }
  const Eigen::Vector3d inverse = moments.cwiseInverse();
  const double shape = std::max((inverse[0] - inverse[2]) * inverse[1] * inverse[1],
                                (inverse[1] - inverse[2]) * inverse[0] * inverse[0]);
  return settings.simulation.dissipation * momentum * momentum * shape;
}

NudgedRotation exactRotation(const MotionSettings& settings) {
  const MotionSettings free = withoutAttitude(settings);
  const rigid::PrincipalAxes inertia = modelInertia(free);
  return NudgedRotation(
      {inertia, free.initial.alongPrincipal(inertia),
       inertia.angularMomentum(initialAngularVelocity(free)), initialAttitude(settings.initial)},
      free.nudges);
}

}  // namespace rotatebook::physics
