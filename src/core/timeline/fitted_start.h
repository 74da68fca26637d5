// The start of the exact motion that fits a recording best. Inside the room only.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/sample.h"
#include "rigid/inertia.h"

namespace rotatebook::timeline {

/// A body at t = 0.
struct FittedStart {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< World from body.
  Eigen::Vector3d angularVelocity{0, 0, 0};                      ///< In body axes. [rad/s]
};

/// Fits the start of the exact motion to the attitudes of `samples`, by Gauss and Newton's method:
/// first to the first few, then to half as many more each time, up to all, so that a motion that
/// grows apart from that of the first sample is followed. At most 200 samples are taken at once.
FittedStart fitStart(const rigid::PrincipalAxes& inertia,
                     const std::vector<physics::Sample>& samples);

/// Fits likewise to a first part of which the body turns by `turn`, or to 12 samples: wrong steps
/// matter little there. [rad]
FittedStart fitFirst(const rigid::PrincipalAxes& inertia,
                     const std::vector<physics::Sample>& samples, double turn);
/// Fits likewise to a last part, whose start is returned. [rad]
FittedStart fitLast(const rigid::PrincipalAxes& inertia,
                    const std::vector<physics::Sample>& samples, double turn);

}  // namespace rotatebook::timeline
