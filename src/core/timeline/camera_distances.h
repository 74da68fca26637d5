// The camera's distance from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// The camera's distance from its target in each frame of each motion, as a multiple of the one
/// that the scene states. With scene::Follow::Size it draws back once a body grows beyond the
/// picture, which then keeps filling it, and comes back slowly after a body that shrinks again. It
/// does so smoothly, as the whole motion is known in advance. The multiple is exactly 1 for a body
/// that keeps its size within 8 %, and limited by physics::kDivergenceFactor. With scene::Fit::Each
/// it is that times the body's size, as a share of the largest body's.
class CameraDistances {
 public:
  CameraDistances(const scene::Scene& scene, const ClipMotion& motion);

  /// Returns the multiple, > 0, for motion `motion` in `frame`, 0 to below motion.frameCount().
  double at(std::size_t motion, std::int64_t frame) const {
    const double own = shares_.empty() ? 1 : shares_[motion];
    return multiples_.empty() ? own : own * multiples_[motion][static_cast<std::size_t>(frame)];
  }

 private:
  std::vector<std::vector<double>> multiples_;  // none if the camera keeps its distance
  std::vector<double> shares_;                  // by motion; none if all have the same distance
};

/// Returns the multiple that CameraDistances has for a body that keeps its size, without the
/// motion.
double distanceAtRest(const scene::Scene& scene, std::size_t motion);

}  // namespace rotatebook::timeline
