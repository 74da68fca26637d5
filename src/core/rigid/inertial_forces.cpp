#include "rigid/inertial_forces.h"

#include <Eigen/Geometry>

namespace rotatebook::rigid {

using Eigen::Vector3d;

Turning freeTurning(const PrincipalAxes& inertia, const Vector3d& rate) {
  return {rate, inertia.angularVelocity(inertia.angularMomentum(rate).cross(rate))};
}

ForcesPerMass forcesIn(const Turning& frame, const Eigen::Matrix3d& frameFromBody,
                       const Turning& body, const Vector3d& place) {
  const Vector3d& O = frame.rate;
  const Vector3d X = frameFromBody * place;
  const Vector3d V = frameFromBody * body.rate.cross(place) - O.cross(X);
  return {
      -O.cross(O.cross(X)), -2 * O.cross(V), -frame.acceleration.cross(X),
      frameFromBody * (body.acceleration.cross(place) + body.rate.cross(body.rate.cross(place)))};
}

}  // namespace rotatebook::rigid
