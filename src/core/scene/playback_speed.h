// The speed at which a clip shows its motion.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/moment.h"

namespace rotatebook::scene {

/// A stretch of a clip that shows the motion at a speed of its own.
struct SpeedStretch {
  double from = 0;   ///< >= 0. [s] of video
  double to = 0;     ///< > from. [s] of video
  double value = 1;  ///< Simulated time over time of video, >= 0; 0 holds the picture.
  /// The moments of the motion that are stated in place of `from` and `to`. Speeds go without such
  /// a stretch until schedule() finds its times.
  std::optional<Moment> begin{}, end{};

  bool hasMoments() const { return begin || end; }

  friend bool operator==(const SpeedStretch&, const SpeedStretch&) = default;
};

/// Half the longest time in which one speed passes to the next. [s] of video
inline constexpr double kHalfPassage = 0.25;

/// The speed of a whole clip, in simulated time over time of video: constant but for some
/// stretches.
struct PlaybackSpeed {
  double constant = 1;                    ///< > 0; 1 if stretches are stated.
  std::vector<SpeedStretch> stretches{};  ///< In the order of time, none over another.

  /// Returns the speed that is stated for a time of the video, without passages. [s]
  double at(double videoTime) const;
  /// Returns the simulated time at a time of the video >= 0. [s] The speed passes from one value to
  /// the next by a smoothstep, 3u^2 - 2u^3, from kHalfPassage before the change to as long after
  /// it, or within half the time to the neighbouring change where that is shorter. As a passage is
  /// symmetric, it changes no time outside it. A stretch until the video's `end` passes to nothing.
  double timeAt(double videoTime, double end = std::numeric_limits<double>::infinity()) const;

  friend bool operator==(const PlaybackSpeed&, const PlaybackSpeed&) = default;
};

}  // namespace rotatebook::scene
