// The paper's second way: a rigid body whose attitude is a rotation matrix.
#pragma once

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/rigid_body.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Free rigid body: constant angular momentum L, attitude R (world from body). One step is explicit
/// Euler, w = R I^-1 R^T L, R += h [w]x R, then, if normalised, R becomes the nearest orthogonal
/// matrix. Without that a step lengthens R by sqrt(1 + (h |w|)^2) in all directions across w, and
/// the drawn body with it.
class MatrixSimulator final : public Simulator {
 public:
  explicit MatrixSimulator(const MotionSettings& settings);

  void advance(double h) override;
  BodyState state() const override { return body_.state(worldFromBody_); }

 private:
  RigidBody body_;
  Eigen::Matrix3d worldFromBody_ = Eigen::Matrix3d::Identity();
  bool normalize_;
};

}  // namespace rotatebook::physics
