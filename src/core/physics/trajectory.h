// A whole motion as a value.
#pragma once

#include <optional>
#include <vector>

#include "physics/sample.h"

namespace rotatebook::physics {

/// A motion: one sample every `interval`, the first at t = 0.
struct Trajectory {
  double interval = 0;          ///< [s]
  std::vector<Sample> samples;  ///< Never empty.
  /// Time of the first sample that doesn't exist, because there a corner was farther from the
  /// origin than kDivergenceFactor times the body's largest dimension, or a number was not finite.
  /// [s]
  std::optional<double> divergedAt{};
};

/// See Trajectory::divergedAt.
inline constexpr double kDivergenceFactor = 20;

}  // namespace rotatebook::physics
