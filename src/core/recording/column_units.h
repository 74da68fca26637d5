// The units of a table's columns, by their names. Inside the room only.
#pragma once

#include <optional>
#include <string_view>

#include "recording/csv_table.h"
#include "recording/read_options.h"
#include "recording/table_columns.h"

namespace rotatebook::recording {

/// Returns whether a column is called as a gyroscope's, which measures along the body's axes.
bool isGyroscopes(std::string_view header);

/// Returns whether a column called so (ColumnName::plain) has times: `usual`, which may be followed
/// by a unit ("timems", "timeinms").
bool isTimeNamed(std::string_view plain, std::string_view usual);

/// Returns whether a column has the whole seconds of ROS's times, which have nanoseconds beside
/// them.
bool areSecondsOfRos(std::string_view header);

/// Sets the unit of the times: `stated`, one of kTimeUnits, or if that is empty the header's.
/// Throws InputError for a header's unit that isn't read.
void findTimeUnit(const CsvTable& table, Columns& columns, std::string_view stated);

/// Returns the one of ms, us, ns and min in which a recording whose rows are `interval` apart has 5
/// to 10^6 rows a second, or of the first three in which its last time is one of a calendar; empty
/// if none is.
std::string_view plausibleUnit(double interval, double last);

/// Returns the unit that a header states for a rate; nothing if it states none that is known.
/// [rad/s]
std::optional<double> rateUnitIn(std::string_view header);
/// Returns the unit of the table's rates: `stated`, or if that is empty the headers'. Throws
/// InputError if there is none, or if they differ. [rad/s]
double radiansPerUnit(const CsvTable& table, const Columns& columns, std::string_view stated);

/// Returns the unit that a header states for an acceleration; nothing if it states none that is
/// known. [m/s^2]
std::optional<double> accelerationUnitIn(std::string_view header);
/// Returns the unit of the table's accelerations, m/s^2 where the headers have none. Throws
/// InputError for another that isn't read, or if they differ. [m/s^2]
double metresPerUnit(const CsvTable& table, const Columns& columns);

}  // namespace rotatebook::recording
