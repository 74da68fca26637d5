// A gyroscope's recording, with an accelerometer or without, and what is stated about a toss in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "recording/gyroscope.h"

namespace rotatebook::recording {

/// A gyroscope's reading, and the specific force beside it.
struct InertialReading {
  Rate rate;
  Eigen::Vector3d force{0, 0, 0};  ///< In body axes; 0 without an accelerometer. [m/s^2]
};

/// A recording of a gyroscope, with an accelerometer or without.
struct InertialRecording {
  std::vector<InertialReading> readings;
  double zero = 0;  ///< Time of the file at which the readings' times are 0. [s]
  bool hasForce = false;
  bool isMeasured = true;            ///< By a gyroscope; else the rates are slopes of attitudes.
  std::vector<std::string> notes{};  ///< As RecordedMotion::notes().
};

/// A table of text.
struct NamedTable {
  std::string_view bytes;
  std::string name;  ///< For messages.
};

/// Statements about a toss that its recording doesn't make.
struct TossOptions {
  std::optional<double> from{}, to{};  ///< The flight, of the file's times. [s]
  /// Largest distance of the accelerometer from the centre of mass, for the search for the flight,
  /// >= 0. [m]
  double lever = 0.05;
};

/// Slowest spin and shortest duration of throws that are found by rates alone. [rad/s, s]
inline constexpr double kSlowestThrow = 2, kShortestThrow = 0.25;

/// Returns a time for people, to a ten-thousandth of a second.
std::string timeText(double time);

}  // namespace rotatebook::recording
