#include "scene/reference_frame.h"

#include <Eigen/Geometry>

#include "rigid/rotation.h"

namespace rotatebook::scene {
namespace {

/// Returns the smallest rotation that takes the unit vector `from` to +y.
Eigen::Matrix3d rotationToY(const Eigen::Vector3d& from) {
  constexpr double kMin = 1e-12;  // smallest 1 + cosine to divide by
  const double cosine = from.y();
  if (1 + cosine < kMin) return Eigen::Vector3d(1, -1, -1).asDiagonal();
  const Eigen::Vector3d axis = from.cross(Eigen::Vector3d::UnitY());  // its length is the sine
  return cosine * Eigen::Matrix3d::Identity() + rigid::crossMatrix(axis) +
         axis * axis.transpose() / (1 + cosine);
}

}  // namespace

Eigen::Matrix3d frameFromWorld(ReferenceFrame frame, const physics::Sample& sample) {
  switch (frame) {
    case ReferenceFrame::World:
      break;
    case ReferenceFrame::Body:
      return sample.attitude.toRotationMatrix().transpose();
    case ReferenceFrame::Momentum: {
      const double size = sample.angularMomentum.stableNorm();
      if (size > 0) return rotationToY(sample.angularMomentum / size);
    }
  }
  return Eigen::Matrix3d::Identity();
}

physics::Sample inReferenceFrame(ReferenceFrame frame, const physics::Sample& sample) {
  requireSameLayout();
  if (frame == ReferenceFrame::World) return sample;
  const Eigen::Matrix3d rotation = frameFromWorld(frame, sample);
  physics::Sample seen = sample;
  seen.cage = rotation * sample.cage;
  seen.attitude = Eigen::Quaterniond(rotation) * sample.attitude;
  seen.angularVelocity = rotation * sample.angularVelocity;
  seen.angularMomentum = rotation * sample.angularMomentum;
  return seen;
}

}  // namespace rotatebook::scene
