#include "rigid/inertial_forces.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace rotatebook::rigid {

using Eigen::Vector3d;

Turning freeTurning(const Eigen::Matrix3d& inertia, const Vector3d& rate) {
  const Vector3d momentum = inertia * rate;
  return {rate, inertia.inverse() * momentum.cross(rate)};
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
