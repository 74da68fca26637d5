// The exact model: a rigid body's motion in closed form. Inside the room only.
#pragma once

#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "physics/simulator.h"
#include "rigid/exact_rotation.h"

namespace rotatebook::physics {

/// A simulator without steps: it evaluates the closed form at the time that steps would have
/// reached. Keeps all constants of the motion to rounding, whatever the step.
class ExactSimulator final : public Simulator {
 public:
  explicit ExactSimulator(const MotionSettings& settings);

  void advance(double interval, int steps) override;
  void advancePart(double part) override { advance(part, 1); }
  /// Does nothing: the closed form knows all nudges and their times.
  void nudge(const Nudge& /*nudge*/) override {}
  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<ExactSimulator>(*this);
  }
  BodyState state() const override;

 private:
  double time() const { return start_ + static_cast<double>(count_) * interval_; }

  NudgedRotation rotation_;
  // A count of intervals keeps the time accurate to rounding after any number of equal ones.
  double start_ = 0;
  double interval_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace rotatebook::physics
