// The tilt of an exact motion, without its attitude.
#pragma once

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/nudged_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Computes Sample::tiltDeg of an exact motion, but for rounding, from the angular velocity in body
/// axes alone. A map of tilts takes 0.58 of the processor time that it takes with samples.
class ExactTilt {
 public:
  /// Throws InputError as InitialSpin::tilted() does.
  explicit ExactTilt(const MotionSettings& settings);

  /// Returns the tilt at any time [s]. [degrees]
  double degAt(double time) const;

 private:
  rigid::PrincipalAxes inertia_;
  Eigen::Vector3d spunAxis_;
  NudgedRotation rotation_;
};

}  // namespace rotatebook::physics
