// The paper's third way: a rigid body whose attitude is a quaternion.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/motion_settings.h"
#include "physics/rigid_body.h"
#include "physics/rotation.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// Free rigid body: constant angular momentum L, attitude q (world from body). One step is explicit
/// Euler, w = A(q) I^-1 A(q)^T L, q += h/2 (0, w) q, then, if normalised, q /= |q|. Without that a
/// step multiplies |q|^2 by 1 + (h |w| / 2)^2. A is textbookMatrix(), not divided by |q|^2: with
/// the division the drawn body would stay rigid and the missing normalisation would not show.
class QuaternionSimulator final : public Simulator {
 public:
  explicit QuaternionSimulator(const MotionSettings& settings);

  void advance(double h) override;
  BodyState state() const override { return body_.state(textbookMatrix(attitude_)); }

 private:
  RigidBody body_;
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();
  bool normalize_;
};

}  // namespace rotatebook::physics
