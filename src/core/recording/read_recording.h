// Reads recordings: attitudes, a gyroscope's rates, or this program's own tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"
#include "recording/gyroscope.h"
#include "recording/read_options.h"
#include "recording/recorded_motion.h"

namespace rotatebook::recording {

/// Reports that the rates of a table contradict the attitudes beside them: axes, units or an order
/// of columns are others than those that the table is read with.
class ContradictionError : public InputError {
 public:
  using InputError::InputError;
};

/// Reads a motion from the bytes of a file; `name` is the file's in messages. Attitudes with rates
/// beside them have these; attitudes alone are differentiated; rates alone,
/// along the body's axes, are integrated. Throws InputError "NAME:LINE: PROBLEM" for what CsvTable
/// and findColumns() refuse, for times that don't ascend, for quaternions and matrices that are no
/// rotations to 1 %, rates over 1e9 rad/s, and for a part that isn't within the recording;
/// ContradictionError for what compareRates() finds in that part, and for a gyroscope's rates that
/// differ by more than kContradicts from the slopes of the attitudes.
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
