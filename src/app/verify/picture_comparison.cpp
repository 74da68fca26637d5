#include "verify/picture_comparison.h"

#include <algorithm>
#include <cmath>

#include "store/clip_files.h"

namespace rotatebook::verify {
namespace {

// Frames on either side with which a picture is compared: each picture, and one that fails.
constexpr std::int64_t kReach = 1;
constexpr std::int64_t kFarReach = 5;

// A picture belongs to another frame if its distance to that frame, over the distance to its own,
// is less than this. Measured from 64x36 to 1280x720: at least 0.73 in correct clips (160x90 at crf
// 42; 2.6 at crf 18), at most 0.38 in clips that are off by a frame, at crf 18.
constexpr double kCloserRatio = 0.6;

}  // namespace

// Measured on 24 frames of scenes/starter.toml: the largest rms and rms of the worst block from
// 64x36 to 1280x720, then the smallest with the book turned by a degree, at 320x180 and at
// 1280x720:
//   crf 1   0.8   2.0   3.1 19    3.8 47
//   crf 18  2.5   6.0   3.1 19    3.8 47
//   crf 24  4.0  10.5   3.2 19    3.8 47
//   crf 30  6.3  16     3.5 18    3.7 47
//   crf 36 10    28     3.8 21    3.8 48
//   crf 42 15    42     4.3 19    3.9 48
//   crf 51 19    42     5.2 22    4.5 50
//   WebM    2.2   4.7   3.2 19    3.8 47
// The largest on five scenes of figures and comparisons, at 640x360 and crf 18: 2.1 and 7.1.
video::Distance encodingBound(video::VideoFormat format, int crf) {
  const double step = rowOf(format).recorded.lossesOfCrf.value_or(crf) - 18;
  return {.rms = std::clamp(3.8 * std::exp2(step / 9), 1.5, 26.0),
          .worstBlock = std::clamp(10 * std::exp2(step / 8), 4.0, 60.0)};
}

PictureComparison::PictureComparison(const scene::Scene& scene, picture::FrameDrawer& drawer,
                                     std::int64_t frames, video::VideoFormat format)
    : drawer_(&drawer),
      frames_(frames),
      transparent_(scene::isTransparent(scene)),
      bound_(encodingBound(format, scene.video.crf)),
      picture_(drawer.makePicture()) {}

PictureCheck PictureComparison::compare(std::int64_t frame, const video::Planes& picture) {
  // Forget frames that ascending comparisons don't need again
  drawn_.erase(drawn_.begin(), drawn_.lower_bound(frame - kReach));
  PictureCheck check{frame, video::distance(picture, drawn(frame)), bound_};
  const double rms = check.measured.rms;
  check.closerTo = closerFrame(frame, picture, rms, kReach);
  if (!check.passed()) check.closerTo = closerFrame(frame, picture, rms, kFarReach);
  return check;
}

std::optional<std::int64_t> PictureComparison::closerFrame(std::int64_t frame,
                                                           const video::Planes& picture, double rms,
                                                           std::int64_t reach) {
  std::optional<std::int64_t> found;
  double smallest = kCloserRatio * rms;
  const std::int64_t last = std::min(frame + reach, frames_ - 1);
  for (std::int64_t other = std::max<std::int64_t>(frame - reach, 0); other <= last; ++other) {
    const double distance = video::distance(picture, drawn(other)).rms;
    if (distance >= smallest) continue;
    smallest = distance;
    found = other;
  }
  return found;
}

const video::Planes& PictureComparison::drawn(std::int64_t frame) {
  const auto known = drawn_.find(frame);
  if (known != drawn_.end()) return known->second;
  drawer_->draw(frame, picture_);
  return drawn_[frame] = video::planesOf(picture_.view(), transparent_);
}

}  // namespace rotatebook::verify
