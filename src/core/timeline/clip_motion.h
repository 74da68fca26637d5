// The motions that a clip shows, on one clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/frame_rate.h"
#include "physics/trajectory.h"

namespace rotatebook::timeline {

/// All that moves in a clip. Frame n shows sample n of every motion; of a motion that diverged
/// before, its last sample. This is where it is known how many frames a clip has.
class ClipMotion {
 public:
  /// `trajectories`, at least one, each have as many samples as the clip is to have frames at
  /// `rate`, or fewer if they diverge.
  ClipMotion(std::vector<physics::Trajectory> trajectories, FrameRate rate);

  const std::vector<physics::Trajectory>& trajectories() const { return trajectories_; }

  /// Frames of the clip. Once all motions have diverged it holds its last picture for one second
  /// and ends, be that before or after the end that was asked for.
  std::int64_t frameCount() const;
  /// Whether all motions have diverged, so that frameCount() isn't what was asked for.
  bool allDiverge() const;
  /// Index of the sample of motion `motion` that `frame` (0 to below frameCount()) shows.
  std::size_t sampleAt(std::size_t motion, std::int64_t frame) const;
  /// Whether `frame` shows a motion that has diverged.
  bool isHeld(std::size_t motion, std::int64_t frame) const;
  /// The frame whose time a clock shows at `frame`: it stops with the last motion.
  std::int64_t clockFrame(std::int64_t frame) const;

 private:
  std::int64_t longest() const;

  std::vector<physics::Trajectory> trajectories_;
  FrameRate rate_;
};

}  // namespace rotatebook::timeline
