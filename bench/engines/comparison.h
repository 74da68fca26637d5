// An engine's distance from the exact motion, and the cost of a step.
#pragma once

#include <optional>
#include <vector>

#include "engines/engine.h"

namespace rotatebook::bench {

/// Duration of every row's motion. [s]
inline constexpr double kDuration = 10;
/// From a look at the body to the next; a whole number of steps of each length in the table. [s]
inline constexpr double kInterval = 0.05;

/// Result of one mode at one length of step.
struct Row {
  double lastError = 0;      ///< Angle from the exact attitude at kDuration. [rad]
  double largestError = 0;   ///< The largest such angle at any look. [rad]
  double energyDrift = 0;    ///< E/E0 - 1 at kDuration.
  double momentumDrift = 0;  ///< |L|/|L0| - 1 at kDuration.
  int halfTurns = 0;         ///< Turns of the spun axis from along L to against it.
  double nanoseconds = 0;    ///< Processor time a step, the fastest of several whole runs. [ns]
  std::optional<int> chosenSteps{};  ///< In all; if the engine chooses.
};

/// Measures modes against the exact solution of one motion.
class Comparison {
 public:
  explicit Comparison(const Motion& motion);

  /// Runs `mode` for kDuration in steps of `step`, a whole fraction of kInterval. [s]
  Row run(const Mode& mode, double step) const;
  /// Of the exact motion.
  int halfTurns() const { return exactHalfTurns_; }

 private:
  int countHalfTurns(const std::vector<EngineState>& looks) const;
  Eigen::Vector3d momentum(const EngineState& state) const;

  Motion motion_;
  Eigen::Vector3d inertia_;
  std::vector<EngineState> exact_;  // One a look, the first at kInterval.
  int exactHalfTurns_ = 0;
};

}  // namespace rotatebook::bench
