#include "scene/spin_axis.h"

#include <algorithm>
#include <array>
#include <string>

#include "physics/motion_start.h"
#include "scene/names.h"
#include "scene/solid_particles.h"

namespace rotatebook::scene {
namespace {

/// Returns the principal axis, 0 to 2, about which a spin is stated by the rank of its moment.
int axisOf(const physics::SpinAbout& about, const Eigen::Vector3d& moments) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, {}, [&](int axis) { return moments[axis]; });
  return order[static_cast<std::size_t>(about.rank)];
}

/// Throws InputError if another moment equals that of the axis, which is any of a plane then.
void requireOneAxis(const Motion& motion, const rigid::PrincipalAxes& axes, int axis) {
  const Eigen::Vector3d moments = rigid::withEqualMoments(axes).moments;
  for (int other = 0; other < 3; ++other) {
    if (other == axis || moments[other] != moments[axis]) continue;
    const std::string key = "initial." + std::string(nameOf(kSpinKinds, motion.initial.kind));
    document::failAt(motion.locations.of({key}),
                     key +
                         ": two moments of this body are equal, so that no single axis has that "
                         "one; state the spin as three numbers");
  }
}

}  // namespace

void turnSpinToAxis(Motion& motion) {
  const rigid::PrincipalAxes axes = physics::modelInertia(motion);
  Eigen::Vector3d axis = axes.bodyFromPrincipal.col(axisOf(*motion.initial.about, axes.moments));
  // Of both directions, take the one whose largest component is positive
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0) axis = -axis;
  motion.initial.value = motion.initial.about->rate * axis;
}

void settleSpin(Motion& motion) {
  if (!motion.initial.about || lacksSurface(motion)) return;
  const rigid::PrincipalAxes axes = physics::modelInertia(motion);
  requireOneAxis(motion, axes, axisOf(*motion.initial.about, axes.moments));
  turnSpinToAxis(motion);
  motion.locations.failAt({"initial.tilt"}, [&] { motion.initial.tilted(); });
}

}  // namespace rotatebook::scene
