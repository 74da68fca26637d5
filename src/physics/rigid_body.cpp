#include "physics/rigid_body.h"

namespace rotatebook::physics {

RigidBody::RigidBody(const MotionSettings& settings)
    : corners_(settings.body.corners()),
      inverseInertia_(modelInertia(settings).cwiseInverse()),
      angularMomentum_(modelInertia(settings).cwiseProduct(initialAngularVelocity(settings))) {}

Eigen::Vector3d RigidBody::angularVelocity(const Eigen::Matrix3d& worldFromBody) const {
  const Eigen::Vector3d momentumBody = worldFromBody.transpose() * angularMomentum_;
  return worldFromBody * inverseInertia_.cwiseProduct(momentumBody);
}

BodyState RigidBody::state(const Eigen::Matrix3d& worldFromBody) const {
  BodyState result;
  result.corners = worldFromBody * corners_;
  result.angularVelocity = angularVelocity(worldFromBody);
  result.angularMomentum = angularMomentum_;
  result.kinetic = result.angularVelocity.dot(angularMomentum_) / 2;
  result.rotational = result.kinetic;
  return result;
}

}  // namespace rotatebook::physics
