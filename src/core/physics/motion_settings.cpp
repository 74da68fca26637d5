#include "physics/motion_settings.h"

#include <cmath>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::physics {

const std::size_t kMotionSettingsSize = sizeof(MotionSettings);

namespace {

// Sine of the angle to the axis below which two directions count as parallel. Numbers that a person
// writes are either exactly parallel or far from it; rounding in a program that computed them stays
// below this.
constexpr double kParallel = 1e-12;

std::string text(const Eigen::Vector3d& v) {
  return "(" + shortestText(v.x()) + ", " + shortestText(v.y()) + ", " + shortestText(v.z()) + ")";
}

[[noreturn]] void throwParallel(const Eigen::Vector3d& value, int axis) {
  const std::string name(1, "xyz"[axis]);
  throw InputError("can't tilt the initial spin " + text(value) + " toward " + name +
                   ": it points along that axis already; tilt it toward another axis");
}

}  // namespace

Integrator defaultIntegrator(Model model) {
  return model == Model::Particles ? Integrator::Euler : Integrator::Rk4;
}

Eigen::Vector3d InitialSpin::tilted() const {
  if (!tilt) return value;
  const int axis = tilt->axis;
  const double length = value.norm();
  const Eigen::Vector3d direction = value / length;

  // Compute the part across the axis from its own components: 1 - cos^2 would lose its digits near
  // the axis.
  const double along = direction[axis];
  const double across = roundedHypotenuse(direction[(axis + 1) % 3], direction[(axis + 2) % 3]);
  if (!(across > kParallel)) throwParallel(value, axis);

  // The unit vector perpendicular to `direction`, in its plane with the axis, on the axis' side.
  Eigen::Vector3d toward = -along / across * direction;
  toward[axis] = across;
  return length * (cosine(tilt->angle) * direction + sine(tilt->angle) * toward);
}

Eigen::Vector3d InitialSpin::angularVelocity(const rigid::PrincipalAxes& inertia) const {
  return kind == Kind::AngularVelocity ? tilted() : inertia.angularVelocity(tilted());
}

DoubleDouble3 InitialSpin::alongPrincipal(const rigid::PrincipalAxes& inertia) const {
  DoubleDouble3 along = inertia.alongPrincipal(tilted());
  if (kind == Kind::AngularVelocity) return along;
  const DoubleDouble3 moments = inertia.preciseMoments();
  for (std::size_t i = 0; i < 3; ++i) along[i] = along[i] / moments[i];
  return along;
}

}  // namespace rotatebook::physics
