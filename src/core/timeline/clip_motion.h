// The motions that a clip shows, on one clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/frame_rate.h"
#include "base/layout.h"
#include "physics/trajectory.h"

namespace rotatebook::timeline {

/// All motions of a clip. Frame n shows sample n of every motion, or the last sample of a motion
/// that has diverged before. It decides how many frames a clip has.
class ClipMotion {
 public:
  /// Takes at least one trajectory. Each has as many samples as the clip is to have frames at
  /// `rate`, or fewer if it diverges.
  ClipMotion(std::vector<physics::Trajectory> trajectories, FrameRate rate);

  const std::vector<physics::Trajectory>& trajectories() const { return trajectories_; }

  /// Returns the number of frames of the clip. Once all motions have diverged, the clip holds its
  /// last picture for one second and ends, be that before or after the requested end.
  std::int64_t frameCount() const;
  /// Returns whether all motions have diverged, so that frameCount() isn't as requested.
  bool allDiverge() const;
  /// Returns the index of the sample of motion `motion` that `frame` (0 to below frameCount())
  /// shows.
  std::size_t sampleAt(std::size_t motion, std::int64_t frame) const;
  /// Returns whether motion `motion` has diverged by `frame`, which shows its last sample.
  bool isHeld(std::size_t motion, std::int64_t frame) const;
  /// Returns the frame whose time a clock shows at `frame`: the clock stops with the last motion.
  std::int64_t clockFrame(std::int64_t frame) const;

 private:
  std::int64_t longest() const;

  std::vector<physics::Trajectory> trajectories_;
  FrameRate rate_;
};

extern const std::size_t kClipMotionSize;  // in the library
namespace {
[[maybe_unused]] const bool kClipMotionIsSame =
    noteSize("timeline::ClipMotion", kClipMotionSize, sizeof(ClipMotion));
}  // namespace

}  // namespace rotatebook::timeline
