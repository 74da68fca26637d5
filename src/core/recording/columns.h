// The columns of a recording, recognised by their names.
#pragma once

#include <string_view>
#include <vector>

#include "recording/csv_table.h"
#include "recording/read_options.h"
#include "recording/table_columns.h"

namespace rotatebook::recording {

/// Returns what columns may hold: time, qw to qz, r11 to r33, wx to wz, ax to az.
std::vector<std::string_view> columnRoles();

/// Returns the columns that `table` has: those that the options name, the others by usual names,
/// whatever their case, spaces and units, see Spellings. Columns called x, y and z alone are those
/// of the sensor that their unit, or the name of the file, says. Throws InputError with the names
/// that there are: if a named column is missing, if there is no time, if a group isn't whole, and
/// if two columns hold the same, of which no name is preferred and none is stated.
Columns columnsIn(const CsvTable& table, const ReadOptions& options);

/// Returns the columns of a motion, with the units and axes that the options state, or the header.
/// Beside attitudes, rates are along the body's axes in columns called as a gyroscope's, and along
/// the world's in others; rates alone are along the body's. Throws InputError like columnsIn(), if
/// there are neither attitudes nor rates, for rates without a unit, and for rates alone along the
/// world's axes.
Columns findColumns(const CsvTable& table, const ReadOptions& options);

}  // namespace rotatebook::recording
