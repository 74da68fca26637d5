// Execution of a study's runs, and how a run may end.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include "physics/motion_settings.h"

namespace rotatebook::study {

/// Stops runs once it is set from outside; may be null.
using Stop = const std::atomic<bool>*;

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The outcome of a run.
struct RunEnd {
  enum class Kind {
    Whole,
    Diverged,       ///< Trajectory::divergedAt
    NoConvergence,  ///< physics::NoConvergence
    StepTooLong,    ///< physics::StepTooLong
  };

  Kind kind = Kind::Whole;
  double time = 0;  ///< Time of divergence. [s]

  /// Returns "ok", "diverged at 1.2 s", "no convergence" or "step too long for its series".
  std::string text() const;
};

/// Makes one run of a study, given its index.
using Run = std::function<void(std::size_t)>;

/// Makes the runs `indices` on the caller's thread, in their order. Returns true.
bool runInTurn(std::span<const std::size_t> indices, const Run& run);

/// The functions that make the runs of a study and measure their time. The core starts no thread
/// and reads no clock; its caller may.
struct Execution {
  /// Calls the run once with each of the indices, started in their order, possibly several at a
  /// time. Returns whether all were made; throws the first error that a run threw.
  std::function<bool(std::span<const std::size_t>, const Run&)> runAll = runInTurn;
  /// Measures the computing time of one step within a motion's first `steps` steps. [ns] Without
  /// it, StudyRow::nsPerStep is NaN.
  std::function<double(const physics::MotionSettings&, std::int64_t steps)> nanosecondsPerStep{};
  /// Stops the study if set from outside; read at every frame. May be null.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace rotatebook::study
