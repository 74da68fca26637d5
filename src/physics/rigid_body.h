// What the two rigid models share.
#pragma once

#include <Eigen/Core>

#include "physics/cuboid.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// A free rigid body of constant angular momentum L, without its attitude. Each function takes the
/// map from body to world that the model has at the moment: a rotation, or what the integrator's
/// drift has made of it.
class RigidBody {
 public:
  explicit RigidBody(const MotionSettings& settings);

  /// w = A I^-1 A^T L of the map A. [rad/s]
  Eigen::Vector3d angularVelocity(const Eigen::Matrix3d& worldFromBody) const;
  /// The state of which nothing is kept in springs.
  BodyState state(const Eigen::Matrix3d& worldFromBody) const;

 private:
  Corners corners_;
  Eigen::Vector3d inverseInertia_;
  Eigen::Vector3d angularMomentum_;
};

}  // namespace rotatebook::physics
