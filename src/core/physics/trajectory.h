// A whole motion as a value.
#pragma once

#include <optional>
#include <vector>

#include "base/layout.h"
#include "physics/sample.h"

namespace rotatebook::physics {

/// A motion: samples in the order of time, the first at t = 0.
struct Trajectory {
  /// SimulationSettings::timePerFrame: the time between samples, unless a caller of simulate()
  /// chose their times. [s]
  double interval = 0;
  std::vector<Sample> samples;  ///< Never empty.
  /// Time of the first missing sample: there a corner was farther from the origin than
  /// kDivergenceFactor times the body's largest dimension, or a number was not finite. [s]
  std::optional<double> divergedAt{};
};

/// Distance from the origin, in largest dimensions of the body, beyond which a motion counts as
/// diverged.
inline constexpr double kDivergenceFactor = 20;

extern const std::size_t kTrajectorySize;  // in the library
namespace {
[[maybe_unused]] const bool kTrajectoryIsSame =
    noteSize("physics::Trajectory", kTrajectorySize, sizeof(Trajectory));
}  // namespace

}  // namespace rotatebook::physics
