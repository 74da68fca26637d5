// The rows of a table in which a sensor has readings, and their times. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recording/csv_table.h"
#include "recording/gyroscope.h"
#include "recording/table_columns.h"

namespace rotatebook::recording {

/// The rows of a table in which the body's motion is, and those with a specific force.
struct SensorRows {
  std::vector<std::size_t> motion, force;
  std::size_t dropped = 0;  ///< At the table's ends, without a reading of the motion.
};

/// Returns the rows of each sensor. Rows without a reading at the table's beginning and end are
/// dropped. Where at most half of the rows have both sensors, they have times of their own, and a
/// row of one may lack the other; else each row between a sensor's first and last needs its
/// reading. Throws InputError "NAME:LINE: PROBLEM" for a row that lacks it; what the force lacks is
/// an error only if `needsForce`.
SensorRows sensorRows(const CsvTable& table, const Columns& columns, bool needsForce);

/// Returns the zero of the times of a table whose first row is `row`: 0, or of a calendar's times
/// the first whole second, as seconds since 1970 leave a double 2e-7 s. [s]
double zeroOf(const CsvTable& table, const Columns& columns, std::size_t row);

/// Returns the times of `rows` after `zero`, to all digits that the table has. Throws InputError
/// "NAME:LINE: PROBLEM" for fewer than two, for times that don't ascend, or by less than 1e-9 s,
/// for times beyond 1e12 s, and if the header doesn't state a unit and seconds aren't plausible.
/// [s]
std::vector<double> timesOf(const CsvTable& table, const Columns& columns,
                            const std::vector<std::size_t>& rows, double zero);

/// Throws InputError for times without a stated unit if the body would turn by more than half a
/// turn from row to row of a sensor or, where rows are nearer than a sensor's, by less than that in
/// all.
void requirePlausibleTurns(const CsvTable& table, const Columns& columns,
                           const std::vector<Rate>& rates);

}  // namespace rotatebook::recording
