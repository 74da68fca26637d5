// A phone's tosses of a book, simulated.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "recording/read_recording.h"
#include "recording/tumbling.h"

namespace rotatebook::recording {

inline constexpr double kInterval = 0.01;        // [s]
inline constexpr double kNoise = 0.05;           // of a rate [deg/s]
inline constexpr int kRest = 100, kFlight = 81;  // readings: 1 s of rest, 0.8 s of flight

/// Errors of a gyroscope besides its noise and a steady bias.
struct GyroscopeErrors {
  double scale = 0;   ///< Of x, and the opposite of y, relative. [-]
  double stamps = 0;  ///< Standard deviation of the times. [s]
  double drift = 0;   ///< Of a bias that walks at random. [rad/s/sqrt(s)]
};

/// A phone's tosses, each with noise of its own.
class Tosses {
 public:
  explicit Tosses(const GyroscopeErrors& errors = {}) : errors_(errors) {}

  /// Returns a recording: a rest, a swing of the hand, a free flight and a catch.
  InertialRecording toss(const Eigen::Vector3d& spin, const Eigen::Matrix3d& axes,
                         const Eigen::Vector3d& moments = kBook) {
    const rigid::ExactRotation motion({moments}, spin);
    InertialRecording recording;
    recording.hasForce = true;
    Eigen::Vector3d walk = Eigen::Vector3d::Zero();
    for (int i = 0; i < kRest + kFlight + 40; ++i) {
      const double flight = (i - kRest - 20) * kInterval;
      const bool isFree = flight >= 0 && flight < (kFlight - 0.5) * kInterval;
      Eigen::Vector3d rate = Eigen::Vector3d::Zero(), force{0, 0, 9.81};
      if (isFree) rate = motion.angularVelocityBodyAt(flight);
      if (isFree) force = 0.02 * rate.squaredNorm() * Eigen::Vector3d(0, 1, 0);
      if (!isFree && i >= kRest) rate = Eigen::Vector3d(3, 1, -2);
      if (!isFree && i >= kRest) force = Eigen::Vector3d(5, -20, 9);
      // Only where they are wanted, so that the random numbers stay those of tosses without them
      if (errors_.drift > 0) walk += errors_.drift * std::sqrt(kInterval) * noise();
      const double shift = errors_.stamps > 0 ? errors_.stamps * normal() : 0;
      const Eigen::Vector3d gains(1 + errors_.scale, 1 - errors_.scale, 1);
      recording.readings.push_back(
          {{4 + i * kInterval + shift,
            gains.cwiseProduct(axes * rate) + kBias + walk + kNoise * kDegree * noise()},
           axes * force});
    }
    return recording;
  }

  /// Returns a spin about the middle axis, well off it, as hands do it.
  Eigen::Vector3d spin() {
    const double speed = 8 + 4 * uniform();
    return speed * (Eigen::Vector3d(1, 0, 0) + 0.3 * direction()).normalized();
  }

  Eigen::Matrix3d axes() { return rotationBy(3 * uniform() * direction()).toRotationMatrix(); }

  const Eigen::Vector3d kBias{0.01, -0.02, 0.015};  // [rad/s]

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double normal() {
    return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * std::numbers::pi * uniform());
  }
  Eigen::Vector3d noise() {
    Eigen::Vector3d result;
    for (double& one : result) one = normal();
    return result;
  }
  Eigen::Vector3d direction() { return noise().normalized(); }

  GyroscopeErrors errors_;
  std::mt19937_64 random_{20250611};
};

}  // namespace rotatebook::recording
