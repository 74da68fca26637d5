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
  std::optional<std::array<std::size_t, 4>> quaternion{};    ///< w, x, y, z; world from body.
  std::optional<std::array<std::size_t, 9>> matrix{};        ///< Row by row; world from body.
  std::optional<std::array<std::size_t, 3>> rates{};         ///< Angular velocity.
  bool areRatesAlongBody = true;                             ///< Else along the world's axes.
  double radiansPerUnit = 1;                                 ///< Of the rates. [rad]
  std::optional<std::array<std::size_t, 3>> acceleration{};  ///< Specific force. [m/s^2]
};

/// Finds the columns of `table`: those that the options name, the others by usual names, whatever
/// their case, spaces and units. Units and axes are those that the options state, or the header's.
/// Beside attitudes, rates are along the body's axes in columns called as a gyroscope's, and along
/// the world's in others; rates alone are along the body's. Throws InputError with the names that
/// there are: if a named column is missing, if there is no time or neither attitudes nor rates, if
/// a group isn't whole, for rates without a unit, and for rates alone along the world's axes.
Columns findColumns(const CsvTable& table, const ReadOptions& options);

}  // namespace rotatebook::recording
