#include "rigid/exact_rotation.h"

namespace rotatebook::rigid {

ExactRotation::ExactRotation(const PrincipalAxes& inertia, const Eigen::Vector3d& angularVelocity)
    : ExactRotation(inertia, withSameLayout(inertia).alongPrincipal(angularVelocity)) {}

ExactRotation::ExactRotation(const PrincipalAxes& inertia, const DoubleDouble3& alongPrincipal)
    : bodyFromPrincipal_(withSameLayout(inertia).bodyFromPrincipal),
      motion_({inertia.preciseMoments(), alongPrincipal}) {}

ExactRotation::Moment ExactRotation::at(double time) const {
  const ExactMotion::Moment moment = motion_.at(time);
  // World axes are the body's at t = 0; those of the closed form are the principal ones.
  const Eigen::Matrix3d worldFromPrincipal = bodyFromPrincipal_ * moment.worldFromBody;
  return {worldFromPrincipal * bodyFromPrincipal_.transpose(),
          worldFromPrincipal * moment.angularVelocityBody};
}

}  // namespace rotatebook::rigid
