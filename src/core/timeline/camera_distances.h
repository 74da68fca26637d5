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
/// that keeps its size within 8 %, and limited by physics::kDivergenceFactor.
class CameraDistances {
 public:
  CameraDistances(const scene::Scene& scene, const ClipMotion& motion);

  /// Returns the multiple, >= 1, for motion `motion` in `frame`, 0 to below motion.frameCount().
  double at(std::size_t motion, std::int64_t frame) const {
    return multiples_.empty() ? 1 : multiples_[motion][static_cast<std::size_t>(frame)];
  }

 private:
  std::vector<std::vector<double>> multiples_;  // none if the camera keeps its distance
};

}  // namespace rotatebook::timeline
