// Steps that all studies have in common. Inside the room only.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/trajectory.h"
#include "study/execution.h"

namespace rotatebook::study {

/// Returns whether a study is to stop. `stop` may be null.
bool isSet(const std::atomic<bool>* stop);

/// Returns the whole motion, or nothing, with the reason in `end`. After a stop it may be cut
/// short; no row of such a study is used.
std::optional<physics::Trajectory> wholeMotion(const physics::MotionSettings& settings,
                                               std::int64_t frames, const std::atomic<bool>* stop,
                                               RunEnd& end);

/// Makes all runs, each with one of `settings`, the longest first. Returns false after a stop.
bool makeRuns(const std::vector<physics::MotionSettings>& settings, const Run& run,
              const Execution& execution);

}  // namespace rotatebook::study
