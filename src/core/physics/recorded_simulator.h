// The recorded model: a motion that was measured, or made by another program. Inside the room only.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/stepless_simulator.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// A simulator without steps: it takes the attitude and the spin from a recording, and the momentum
/// and the energy from the spin and the inertia of `settings`.
class RecordedSimulator final : public SteplessSimulator {
 public:
  /// Throws InputError if the recording hasn't been read.
  explicit RecordedSimulator(const MotionSettings& settings);

  std::unique_ptr<Simulator> copy() const override {
    return std::make_unique<RecordedSimulator>(*this);
  }
  /// Throws InputError more than a frame after the recording's end; before, the body stays as it is
  /// there.
  BodyState state() const override;

 private:
  std::shared_ptr<const recording::RecordedMotion> motion_;
  rigid::PrincipalAxes inertia_;
  double slack_;  // [s]
};

}  // namespace rotatebook::physics
