// The inertia of a body from the gyroscope that flew with it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "recording/read_recording.h"

namespace rotatebook::recording {

/// Statements about a toss that its recording doesn't make.
struct TossOptions {
  std::optional<double> from{}, to{};  ///< The flight, of the recording's times. [s]
  /// Largest distance of the accelerometer from the centre of mass, for the search for the flight,
  /// >= 0. [m]
  double lever = 0.05;
};

/// A number with the interval that holds it in 95 of 100 tosses.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

/// Results of a toss.
struct TossFit {
  double from = 0, to = 0;        ///< The flight, of the recording's times. [s]
  std::size_t readings = 0;       ///< In the flight.
  Eigen::Vector3d bias{0, 0, 0};  ///< Of the gyroscope, from the rest before; 0 without. [rad/s]
  double rest = 0;                ///< Duration of that rest; 0 if there is none. [s]
  /// The inertia tensor in the gyroscope's axes, as a multiple of the largest principal moment. One
  /// that no body has, by its error, is replaced by the nearest flat body's.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  std::array<Estimate, 2> ratios{};  ///< I1/I3 and I2/I3, for I1 <= I2 <= I3.
  Eigen::Vector3d start{0, 0, 0};    ///< Angular velocity at the flight's start. [rad/s]
  double residual = 0;  ///< Root mean square of a rate minus that of the fitted motion. [rad/s]
  /// Smallest but one by smallest singular value: how far the motion tells one inertia from all
  /// others.
  double gap = 0;
};

/// Gap below which a motion doesn't tell its inertia. [-] Steady spins have 1 to 2, tosses that
/// tumble have hundreds.
inline constexpr double kSmallestGap = 5;

/// Fits the inertia, up to its scale, and the motion to the rates of a flight. Start values: with
/// the attitudes R from the rates, R I w - L = 0 is linear in the entries of I and L, and one
/// singular value decomposition gives them. From there the rates of the free motion are fitted to
/// those measured by Gauss and Newton's method, whose covariance gives the intervals, with that of
/// the bias by the scatter of the rest's rates. The flight is where the specific force stays below
/// 2 m/s^2 and the centripetal part; its first and last 2 % are left out. Throws InputError,
/// beginning with `name`, if no flight of 20 readings is found, if the motion doesn't tell the
/// inertia, and if a ratio's interval is wider than 0.5.
TossFit fitToss(const InertialRecording& recording, const std::string& name,
                const TossOptions& options);

}  // namespace rotatebook::recording
