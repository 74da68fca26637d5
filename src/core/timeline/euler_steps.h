// The steps with which explicit Euler shows the right kind of motion.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/motion_settings.h"

namespace rotatebook::timeline {

/// The steps that explicit Euler on a normalised quaternion needs.
struct EulerSteps {
  /// The smallest power of two of SimulationSettings::substeps with which L circles the right axis
  /// throughout; nothing if `tried` aren't enough.
  std::optional<int> substeps{};
  int tried = 0;    ///< The most that were tried.
  double step = 0;  ///< Length of a step of the last run. [s]
};

/// Returns the steps that the motion of `settings` needs over so many frames, found by simulating
/// it with 1, 2, 4 ... substeps; at most 2^26 in a run, and 2^19 substeps. Particles are taken as a
/// rigid body with their moments. Nothing for a motion too long for a single substep, and for one
/// that has no regime to lose: on the separatrix, steady, of a body with equal moments, or in a
/// single frame. Throws InputError as InitialSpin::tilted() does.
std::optional<EulerSteps> eulerStepsFor(const physics::MotionSettings& settings,
                                        std::int64_t frames);

}  // namespace rotatebook::timeline
