// Watches a motion for half-turns and for its end, at a fraction of the cost of its samples.
#pragma once

#include <memory>
#include <optional>

#include "physics/motion_settings.h"

namespace rotatebook::physics {

/// Looks at a motion as Simulation samples it, but measures no errors and no angles.
class TurnWatch {
 public:
  /// Looks at time 0. Throws InputError as Simulation does.
  explicit TurnWatch(const MotionSettings& settings);
  ~TurnWatch();
  TurnWatch(const TurnWatch&) = delete;
  TurnWatch& operator=(const TurnWatch&) = delete;

  /// Looks at `time`, not before those so far. [s] Returns false of a motion that has diverged.
  /// Throws StepError.
  bool look(double time);
  /// Returns Sample::halfTurns of the last look.
  int halfTurns() const;
  /// Returns Trajectory::divergedAt. [s]
  std::optional<double> divergedAt() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::physics
