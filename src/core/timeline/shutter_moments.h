// The moments that are averaged in a picture with motion blur.
#pragma once

#include <cstddef>
#include <vector>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Samples of each motion of a scene within the half frame after each of its samples, while a
/// shutter is open; the first is the sample itself. They come from the same integration steps as
/// the motion.
class ShutterMoments {
 public:
  /// Simulates the motions if there is blur. Throws like physics::simulate().
  explicit ShutterMoments(const scene::Scene& scene);

  /// Returns the number of moments in a picture, scene::LookSettings::motionBlur.
  std::size_t count() const { return count_; }
  /// Returns moment `moment` < count() after sample `sample` of a motion, or the last moment before
  /// the motion diverged.
  const physics::Sample& at(std::size_t motion, std::size_t sample, std::size_t moment) const;

 private:
  std::size_t count_;
  std::vector<physics::Trajectory> motions_;  // with 2 count() samples a frame
};

}  // namespace rotatebook::timeline
