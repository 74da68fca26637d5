// The moments that a picture with motion blur averages.
#pragma once

#include <cstddef>
#include <vector>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Samples of each motion of a scene within the half frame after each of its samples, while a
/// shutter is open; the first is the sample itself. Taken from the same steps as the motion.
class ShutterMoments {
 public:
  /// Throws as physics::simulate() does.
  explicit ShutterMoments(const scene::Scene& scene);

  /// How many there are for a picture, scene::LookSettings::motionBlur.
  std::size_t count() const { return count_; }
  /// Moment `moment` < count() after sample `sample` of a motion. Where the motion has diverged by
  /// then it is the last one before.
  const physics::Sample& at(std::size_t motion, std::size_t sample, std::size_t moment) const;

 private:
  std::size_t count_;
  std::vector<physics::Trajectory> motions_;  // with 2 count() samples a frame
};

}  // namespace rotatebook::timeline
