// The steps with which explicit Euler shows the right kind of motion.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/motion_settings.h"

namespace rotatebook::timeline {

/// The steps that explicit Euler on a normalised quaternion needs.
struct EulerSteps {
  /// The smallest power of two of steps a frame with which L circles the right axis in every frame;
  /// nothing if `tried` aren't enough.
  std::optional<int> substeps{};
  int tried = 0;    ///< The most steps a frame that were tried.
  double step = 0;  ///< Length of a step of the last run. [s]
};

/// Returns the steps that the motion of `settings` needs over so many frames, found by simulating
/// it with 1, 2, 4 ... steps a frame; at most 2^26 in a run, and 2^19 a frame. Particles are taken
/// as a rigid body with their moments. Nothing for a motion that has no regime to lose: on the
/// separatrix, steady, of a body with equal moments, or in a single frame. Throws InputError as
/// InitialSpin::tilted() does.
std::optional<EulerSteps> eulerStepsFor(const physics::MotionSettings& settings,
                                        std::int64_t frames);

}  // namespace rotatebook::timeline
