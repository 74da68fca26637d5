// The columns of a recording, recognised by their names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "recording/csv_table.h"
#include "recording/read_options.h"

namespace rotatebook::recording {

/// Returns what columns may hold: time, qw to qz, r11 to r33, wx to wz, ax to az.
std::vector<std::string_view> columnRoles();

/// The columns of a table, by their indices. A group is there as a whole, or not at all.
struct Columns {
  std::size_t time = 0;
  double secondsPerUnit = 1;                                 ///< Of the time. [s]
  bool isTimeUnitStated = false;                             ///< Else it is taken for seconds.
  std::optional<std::array<std::size_t, 4>> quaternion{};    ///< w, x, y, z; world from body.
  std::optional<std::array<std::size_t, 9>> matrix{};        ///< Row by row; world from body.
  std::optional<std::array<std::size_t, 3>> rates{};         ///< Angular velocity.
  bool areRatesAlongBody = true;                             ///< Else along the world's axes.
  double radiansPerUnit = 1;                                 ///< Of the rates. [rad]
  std::optional<std::array<std::size_t, 3>> acceleration{};  ///< Specific force.
};

/// Returns the columns that `table` has: those that the options name, the others by usual names,
/// whatever their case, spaces and units. Columns called x, y and z alone are those of the sensor
/// that their unit, or the name of the file, says. Throws InputError with the names that there are:
/// if a named column is missing, if there is no time, if a group isn't whole, and if two columns
/// have the same name.
Columns columnsIn(const CsvTable& table, const ReadOptions& options);

/// Returns the columns of a motion, with the units and axes that the options state, or the header.
/// Beside attitudes, rates are along the body's axes in columns called as a gyroscope's, and along
/// the world's in others; rates alone are along the body's. Throws InputError like columnsIn(), if
/// there are neither attitudes nor rates, for rates without a unit, and for rates alone along the
/// world's axes.
Columns findColumns(const CsvTable& table, const ReadOptions& options);

}  // namespace rotatebook::recording
