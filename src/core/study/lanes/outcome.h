// The outcome of a motion, without its samples. Inside the room only.
#pragma once

#include <optional>

namespace rotatebook::study::lanes {

/// Counts and times that the looks at a motion found.
struct Outcome {
  int halfTurns = 0;                   ///< Sample::halfTurns of the last look.
  std::optional<double> firstTurn{};   ///< Time of the look that found the first half-turn. [s]
  std::optional<double> divergedAt{};  ///< Trajectory::divergedAt. [s]
  /// True if there is no such motion, or its integrator couldn't make a step: InputError elsewhere.
  bool isRefused = false;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

}  // namespace rotatebook::study::lanes
