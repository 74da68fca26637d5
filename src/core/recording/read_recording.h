// Reads recordings: attitudes, a gyroscope's rates, or this program's own tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "recording/columns.h"
#include "recording/gyroscope.h"
#include "recording/recorded_motion.h"

namespace rotatebook::recording {

/// Statements about a recording that its file doesn't make.
struct ReadOptions {
  ColumnNames columns{};               ///< Of the columns without a usual name.
  std::string unit{};                  ///< Of rates, one of kRateUnits; if empty, the header's.
  std::optional<double> from{}, to{};  ///< The part to take, of the file's times. [s]
  Eigen::Vector3d bias{0, 0, 0};       ///< Subtracted from a gyroscope's rates. [rad/s]

  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

/// Reads a motion from the bytes of a file; `name` is the file's in messages. Attitudes with rates
/// beside them have these, along the world's axes; attitudes alone are differentiated; rates alone,
/// along the body's axes, are integrated. Throws InputError "NAME:LINE: PROBLEM" for what CsvTable
/// and findColumns() refuse, for times that don't ascend, for quaternions and matrices that are no
/// rotations to 1 %, rates over 1e9 rad/s, and for a part that isn't within the recording.
RecordedMotion readRecording(std::string_view bytes, const std::string& name,
                             const ReadOptions& options);

/// A gyroscope's reading, and the specific force beside it.
struct InertialReading {
  Rate rate;
  Eigen::Vector3d force{0, 0, 0};  ///< In body axes; 0 without an accelerometer. [m/s^2]
};

/// A recording of a gyroscope, with an accelerometer or without.
struct InertialRecording {
  std::vector<InertialReading> readings;
  bool hasForce = false;
};

/// Reads a gyroscope's rates likewise, in the file's own times. Throws InputError if there are no
/// rates alone.
InertialRecording readInertial(std::string_view bytes, const std::string& name,
                               const ReadOptions& options);

}  // namespace rotatebook::recording
