#include "scene/reference_frame.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "base/elementary.h"
#include "physics/motion_start.h"
#include "rigid/rotation.h"

namespace rotatebook::scene {
namespace {

constexpr double kTurnsAtOnce = 1e5;  // kLargestAngle has more

/// Returns the smallest rotation that takes the unit vector `from` to +y.
Eigen::Matrix3d rotationToY(const Eigen::Vector3d& from) {
  constexpr double kMin = 1e-12;  // smallest 1 + cosine to divide by
  const double cosine = from.y();
  if (1 + cosine < kMin) return Eigen::Vector3d(1, -1, -1).asDiagonal();
  const Eigen::Vector3d axis = from.cross(Eigen::Vector3d::UnitY());  // its length is the sine
  return cosine * Eigen::Matrix3d::Identity() + rigid::crossMatrix(axis) +
         axis * axis.transpose() / (1 + cosine);
}

/// Returns the rotation that undoes a steady turning for `time`. (Rodrigues' formula)
Eigen::Matrix3d turnedBack(const Eigen::Vector3d& turning, double time) {
  const double rate = turning.stableNorm();
  if (!(rate > 0)) return Eigen::Matrix3d::Identity();
  // A whole number of turns is left out where sine() ends
  const double turned = std::fmod(rate * time, 2 * std::numbers::pi * kTurnsAtOnce);
  const Eigen::Matrix3d cross = rigid::crossMatrix(turning / rate);
  return Eigen::Matrix3d::Identity() - sine(turned) * cross + (1 - cosine(turned)) * cross * cross;
}

}  // namespace

MotionFrame::MotionFrame(ReferenceFrame frame, const physics::MotionSettings& motion)
    : frame_(frame) {
  if (frame != ReferenceFrame::Turning) return;
  physics::MotionSettings untilted = motion;
  untilted.initial.tilt.reset();
  turning_ = physics::initialAngularVelocity(untilted);
  if (const auto attitude = physics::initialAttitude(motion.initial))
    turning_ = *attitude * turning_;
}

Eigen::Matrix3d MotionFrame::fromWorld(const physics::Sample& sample) const {
  switch (frame_) {
    case ReferenceFrame::World:
      break;
    case ReferenceFrame::Body:
      return sample.attitude.toRotationMatrix().transpose();
    case ReferenceFrame::Momentum: {
      const double size = sample.angularMomentum.stableNorm();
      if (size > 0) return rotationToY(sample.angularMomentum / size);
      break;
    }
    case ReferenceFrame::Turning:
      return turnedBack(turning_, sample.time);
  }
  return Eigen::Matrix3d::Identity();
}

physics::Sample MotionFrame::seen(const physics::Sample& sample) const {
  requireSameLayout();
  if (frame_ == ReferenceFrame::World) return sample;
  const Eigen::Matrix3d rotation = fromWorld(sample);
  physics::Sample seen = sample;
  seen.cage = rotation * sample.cage;
  seen.attitude = Eigen::Quaterniond(rotation) * sample.attitude;
  seen.angularVelocity = rotation * sample.angularVelocity;
  seen.angularMomentum = rotation * sample.angularMomentum;
  return seen;
}

}  // namespace rotatebook::scene
