#include "physics/measure/exact_tilt.h"

#include "physics/measure/measurement.h"
#include "physics/motion_start.h"

namespace rotatebook::physics {

ExactTilt::ExactTilt(const MotionSettings& settings)
    : inertia_(modelInertia(settings)),
      spunAxis_(spunAxisOf(settings, inertia_)),
      rotation_(exactRotation(settings)) {}

double ExactTilt::degAt(double time) const {
  const Eigen::Vector3d momentum = inertia_.angularMomentum(rotation_.angularVelocityBodyAt(time));
  return tiltDegOf(Eigen::Matrix3d::Identity(), spunAxis_, momentum);
}

}  // namespace rotatebook::physics
