// The measured state of a body at one moment.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/layout.h"
#include "body/cuboid.h"
#include "rigid/regime.h"

namespace rotatebook::physics {

/// The measured state of a body at one moment; world axes, SI units unless stated otherwise.
struct Sample {
  double time = 0;  ///< Simulated time. [s]
  /// World from body: the rotation in the polar decomposition of BodyState::worldFromBody. w >= 0
  /// at the start; its sign is continuous after that.
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< About the centre of mass. [kg m^2/s]
  double kinetic = 0;                        ///< [J]
  double potential = 0;                      ///< [J]
  double rotational = 0;  ///< Kinetic energy of the best-fitting rigid motion. [J]
  double tiltDeg = 0;     ///< Angle between the spun body axis and the angular momentum. [degrees]
  /// Number of times that the tilt has gone from under 60 to over 120 degrees or back, before the
  /// body was first deformed beyond what keepsItsShape() allows.
  int halfTurns = 0;
  double stretchMin = 1;  ///< Smallest singular value of BodyState::worldFromBody.
  double stretchMax = 1;  ///< Largest singular value of it.
  /// Angle of the rotation between the attitude and that of the exact rigid motion from the same
  /// initial state. [degrees]
  double errorDeg = 0;
  /// Regime of the rigid motion that would start from this attitude and angular velocity; for
  /// Model::Exact, that of its initial state.
  rigid::Regime regime = rigid::Regime::Separatrix;
  body::Cage cage = body::Cage::Zero();  ///< Corners as drawn. [m]

  double total() const { return kinetic + potential; }
  /// Returns the distance of the centre of mass from the origin, where it starts at rest. Corners
  /// that lie opposite to each other are added first, which for a rigid body gives 0. [m]
  double centreDrift() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i) sum += cage.col(i) + cage.col(7 - i);
    return sum.norm() / 8;
  }
};

extern const std::size_t kSampleSize;  // in the library
namespace {
[[maybe_unused]] const bool kSampleIsSame =
    noteSize("physics::Sample", kSampleSize, sizeof(Sample));
}  // namespace

}  // namespace rotatebook::physics
