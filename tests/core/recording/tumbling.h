// A tumbling book, and what a gyroscope on it reads.
#pragma once

#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "recording/gyroscope.h"
#include "rigid/exact_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::recording {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< [rad]

/// Moments of a book, about x, y, z. [kg m^2]
inline const Eigen::Vector3d kBook{0.00725, 0.00315, 0.00999};

inline rigid::ExactRotation tumbling(const Eigen::Vector3d& spin = {2 * std::numbers::pi, 0.1,
                                                                    0.2}) {
  return {rigid::PrincipalAxes{kBook}, spin};
}

/// Returns the exact rates at `count` times, `interval` apart, or unevenly up to `unevenness` of it
/// before and after. [s]
inline std::vector<Rate> ratesOf(const rigid::ExactRotation& motion, int count, double interval,
                                 double unevenness = 0) {
  std::vector<Rate> rates;
  for (int i = 0; i < count; ++i) {
    const double shift = i % 3 == 1 ? unevenness : 0;
    const double time = (i + shift) * interval;
    rates.push_back({time, motion.angularVelocityBodyAt(time)});
  }
  return rates;
}

/// Returns the angle from an attitude to the exact one at its time. [rad]
inline double errorOf(const rigid::ExactRotation& motion, const RecordedMoment& moment) {
  const Eigen::Quaterniond exact(motion.at(moment.time).worldFromBody);
  return 2 * (exact.conjugate() * moment.attitude).vec().norm();
}

}  // namespace rotatebook::recording
