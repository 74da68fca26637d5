// The units of a table's columns, by their names. Inside the room only.
#pragma once

#include <optional>
#include <string_view>

#include "recording/columns.h"
#include "recording/csv_table.h"
#include "recording/read_options.h"

namespace rotatebook::recording {

/// Usual names of times, in the order of preference.
inline constexpr std::string_view kTimeNames =
    "secondselapsed elapsed time t times ts timestamp elapsedtime timesincestart sampletimefine "
    "seconds zeit temps tiempo tempo tijd";

/// Returns whether a column is called as a gyroscope's, which measures along the body's axes.
bool isGyroscopes(std::string_view header);

/// Returns whether a column called so (ColumnName::plain) has times: `usual`, which may be followed
/// by a unit ("timems", "timeinms").
bool isTimeNamed(std::string_view plain, std::string_view usual);

/// Sets the unit of the times: `stated`, one of kTimeUnits, or if that is empty the header's.
/// Throws InputError for a header's unit that isn't read.
void findTimeUnit(const CsvTable& table, Columns& columns, std::string_view stated);

/// Returns the one of ms, us and ns in which a recording whose rows are `interval` apart has 5 to
/// 10^6 rows a second, or in which its last time is one of a calendar; empty if none is.
std::string_view plausibleUnit(double interval, double last);

/// Returns the one of kRateUnits that a header states; empty if it states none that is known.
std::string_view rateUnitIn(std::string_view header);
/// Returns the unit of the table's rates: `stated`, or if that is empty the headers'. Throws
/// InputError if there is none, or if they differ. [rad]
double radiansPerUnit(const CsvTable& table, const Columns& columns, std::string_view stated);

/// Returns the unit that a header states for an acceleration; nothing if it states none that is
/// known. [m/s^2]
std::optional<double> accelerationUnitIn(std::string_view header);
/// Returns the unit of the table's accelerations, m/s^2 where the headers have none. Throws
/// InputError for another that isn't read, or if they differ. [m/s^2]
double metresPerUnit(const CsvTable& table, const Columns& columns);

}  // namespace rotatebook::recording
