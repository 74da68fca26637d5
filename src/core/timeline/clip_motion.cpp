#include "timeline/clip_motion.h"

#include <algorithm>
#include <utility>

namespace rotatebook::timeline {

const std::size_t kClipMotionSize = sizeof(ClipMotion);
namespace {

constexpr double kHold = 1;  // [s] of video

std::int64_t sampleCount(const physics::Trajectory& trajectory) {
  return static_cast<std::int64_t>(trajectory.samples.size());
}

}  // namespace

ClipMotion::ClipMotion(std::vector<physics::Trajectory> trajectories, FrameRate rate)
    : trajectories_(std::move(trajectories)), rate_(rate) {}

std::int64_t ClipMotion::frameCount() const {
  return longest() + (allDiverge() ? rate_.framesIn(kHold) : 0);
}

bool ClipMotion::allDiverge() const {
  return std::ranges::all_of(trajectories_, [](const physics::Trajectory& trajectory) {
    return trajectory.divergedAt.has_value();
  });
}

std::size_t ClipMotion::sampleAt(std::size_t motion, std::int64_t frame) const {
  return static_cast<std::size_t>(std::min(frame, sampleCount(trajectories_[motion]) - 1));
}

bool ClipMotion::isHeld(std::size_t motion, std::int64_t frame) const {
  return frame >= sampleCount(trajectories_[motion]);
}

std::int64_t ClipMotion::clockFrame(std::int64_t frame) const {
  return std::min(frame, longest() - 1);
}

std::int64_t ClipMotion::longest() const {
  const auto longest = std::ranges::max_element(trajectories_, {}, sampleCount);
  return sampleCount(*longest);
}

}  // namespace rotatebook::timeline
