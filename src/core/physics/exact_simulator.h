// The exact model: a rigid body's motion in closed form. Inside the room only.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "physics/simulator.h"
#include "physics/stepless_clock.h"
#include "rigid/exact_rotation.h"

namespace rotatebook::physics {

/// A simulator without steps: it evaluates the closed form at the time that steps would have
/// reached. Keeps all constants of the motion to rounding, whatever the step.
class ExactSimulator final : public Simulator {
 public:
  explicit ExactSimulator(const MotionSettings& settings);

  void advance(double interval, int /*steps*/) override { clock_.advance(interval); }
  void advancePart(double part) override { clock_.advance(part); }
  bool jumpTo(double time) override {
    clock_.set(time);
    return true;
  }
  /// Does nothing: the closed form knows all nudges and their times.
  void nudge(const Nudge& /*nudge*/) override {}
  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<ExactSimulator>(*this);
  }
  BodyState state() const override;

 private:
  NudgedRotation rotation_;
  SteplessClock clock_;
};

}  // namespace rotatebook::physics
