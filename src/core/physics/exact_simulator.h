// The exact model: a rigid body's motion in closed form. Inside the room only.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "physics/stepless_simulator.h"
#include "rigid/exact_rotation.h"

namespace rotatebook::physics {

/// A simulator without steps: it evaluates the closed form at the time that steps would have
/// reached. Keeps all constants of the motion to rounding, whatever the step.
class ExactSimulator final : public SteplessSimulator {
 public:
  explicit ExactSimulator(const MotionSettings& settings);

  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<ExactSimulator>(*this);
  }
  BodyState state() const override;

 private:
  NudgedRotation rotation_;
};

}  // namespace rotatebook::physics
