// The truth: a rigid body's motion in closed form.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "physics/exact/exact_rotation.h"
#include "physics/motion_settings.h"
#include "physics/simulator.h"

namespace rotatebook::physics {

/// A simulator that doesn't step: it evaluates the closed form where the steps would have led. All
/// constants of the motion are kept to rounding, whatever the step.
class ExactSimulator final : public Simulator {
 public:
  explicit ExactSimulator(const MotionSettings& settings);

  void advance(double h, int steps) override;
  BodyState state() const override;

 private:
  double time() const { return start_ + static_cast<double>(steps_) * h_; }

  Eigen::Vector3d angularMomentum_;
  ExactRotation rotation_;
  // The time is counted, so that it is right to rounding after any number of equal steps.
  double start_ = 0;
  double h_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace rotatebook::physics
