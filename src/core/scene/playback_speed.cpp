#include "scene/playback_speed.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rotatebook::scene {
namespace {

struct Change {
  double at;     // [s] of video
  double speed;  // after it
};

/// Returns all changes of speed before `end`, the first at 0.
std::vector<Change> changesOf(const PlaybackSpeed& speed, double end) {
  std::vector<Change> changes{{0, speed.constant}};
  for (const SpeedStretch& stretch : speed.stretches) {
    if (stretch.hasMoments()) continue;
    // A stretch that begins with the one before, or at 0, replaces the return to the constant.
    if (stretch.from == changes.back().at) changes.pop_back();
    const bool goesOnHolding = stretch.value == 0 && !changes.empty() && changes.back().speed == 0;
    if (!goesOnHolding) changes.push_back({stretch.from, stretch.value});
    if (stretch.to < end) changes.push_back({stretch.to, speed.constant});
  }
  return changes;
}

/// Returns the integral from -half to `x` of a smoothstep that rises from 0 at -half to 1 at half.
double integralOfStep(double x, double half) {
  if (x <= -half) return 0;
  if (x >= half) return x;
  const double u = (x / half + 1) / 2;
  return half * u * u * u * (2 - u);
}

/// Returns half the time in which the speed passes to changes[i].speed. [s]
double halfPassage(const std::vector<Change>& changes, std::size_t i) {
  const double before = changes[i].at - changes[i - 1].at;
  const double after = i + 1 < changes.size() ? changes[i + 1].at - changes[i].at
                                              : std::numeric_limits<double>::infinity();
  return std::min({kHalfPassage, before / 2, after / 2});
}

/// Returns the start of the hold that `videoTime` is in, so that the picture's time is one to the
/// last bit; elsewhere `videoTime`. [s]
double startOfHold(const std::vector<Change>& changes, double videoTime) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i].speed != 0) continue;
    const double start = changes[i].at + (i > 0 ? halfPassage(changes, i) : 0);
    const double end = i + 1 < changes.size() ? changes[i + 1].at - halfPassage(changes, i + 1)
                                              : std::numeric_limits<double>::infinity();
    if (videoTime > start && videoTime < end) return start;
  }
  return videoTime;
}

}  // namespace

double PlaybackSpeed::at(double videoTime) const {
  for (const SpeedStretch& stretch : stretches) {
    if (videoTime >= stretch.from && videoTime < stretch.to) return stretch.value;
  }
  return constant;
}

double PlaybackSpeed::timeAt(double videoTime, double end) const {
  if (stretches.empty()) return constant * videoTime;
  const std::vector<Change> changes = changesOf(*this, end);
  videoTime = startOfHold(changes, videoTime);
  double time = changes.front().speed * videoTime;
  for (std::size_t i = 1; i < changes.size(); ++i) {
    const double gain = changes[i].speed - changes[i - 1].speed;
    time += gain * integralOfStep(videoTime - changes[i].at, halfPassage(changes, i));
  }
  return time;
}

}  // namespace rotatebook::scene
