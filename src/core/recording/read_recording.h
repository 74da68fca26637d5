// Reads recordings: attitudes, a gyroscope's rates, or this program's own tables.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "recording/inertial_recording.h"
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
/// along the body's axes, are integrated. Rows without a reading at the table's ends, gaps and
/// flaws are among the motion's notes. Throws InputError "NAME:LINE: PROBLEM" for what CsvTable,
/// findColumns(), sensorRows() and timesOf() refuse, for quaternions and matrices that are no
/// rotations to 1 %, rates over 1e9 rad/s, and for a part that isn't within the recording;
/// ContradictionError for what compareRates() finds in that part, without what flawsIn() finds.
RecordedMotion readRecording(std::string_view bytes, const std::string& name,
                             const ReadOptions& options);

/// Reads the rates of a gyroscope, or of attitudes, along the body's axes and in the file's own
/// times. The specific force is that of `acceleration`, or if it is null of the same table; where
/// it has times of its own, it is what lies on the straight line between two of them, and infinite
/// beyond. Throws InputError like readRecording(), for accelerations in a unit that isn't read or
/// in none though they seem to be in g, and for two tables that have no time in common.
InertialRecording readInertial(std::string_view bytes, const std::string& name,
                               const ReadOptions& options,
                               const NamedTable* acceleration = nullptr);

/// Readings that a table has.
struct Contents {
  bool hasRates = false, hasAttitudes = false, hasForce = false;
};

/// Returns what a table has by the names of its columns; nothing for what isn't a recording.
Contents contentsOf(const NamedTable& table, const ReadOptions& options);

}  // namespace rotatebook::recording
