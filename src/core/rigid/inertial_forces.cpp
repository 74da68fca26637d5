#include "rigid/inertial_forces.h"

#include <Eigen/Geometry>

namespace rotatebook::rigid {

using Eigen::Vector3d;

Turning freeTurning(const PrincipalAxes& inertia, const Vector3d& w, double dissipation) {
  const Vector3d L = inertia.angularMomentum(w);
  const Vector3d a = inertia.angularVelocity(L.cross(w));
  if (dissipation == 0) return {w, a};
  const Vector3d rate = w + dissipation * inertia.angularVelocity(a);
  const Vector3d ofL = L.cross(rate), ofW = inertia.angularVelocity(ofL);
  const Vector3d ofA = inertia.angularVelocity(ofL.cross(w) + L.cross(ofW));
  return {rate, ofW + dissipation * inertia.angularVelocity(ofA)};
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
