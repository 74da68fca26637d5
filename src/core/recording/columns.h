// The columns of a recording, recognised by their names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/csv_table.h"

namespace rotatebook::recording {

/// The units of rates, as options state them.
inline constexpr std::array<std::string_view, 2> kRateUnits{"rad/s", "deg/s"};

/// Names of columns by what they hold: {"time", "t"}, {"wx", "Gyro X"}. What a column holds is one
/// of columnRoles().
using ColumnNames = std::vector<std::pair<std::string, std::string>>;

/// Returns what columns may hold: time, qw to qz, r11 to r33, wx to wz, ax to az.
std::vector<std::string_view> columnRoles();

/// The columns of a table, by their indices. A group is there as a whole, or not at all.
struct Columns {
  std::size_t time = 0;
  double secondsPerUnit = 1;                               ///< Of the time. [s]
  std::optional<std::array<std::size_t, 4>> quaternion{};  ///< w, x, y, z; world from body.
  std::optional<std::array<std::size_t, 9>> matrix{};      ///< Row by row; world from body.
  /// Angular velocity: along the world's axes beside attitudes, else along the body's.
  std::optional<std::array<std::size_t, 3>> rates{};
  double radiansPerUnit = 1;                                 ///< Of the rates. [rad]
  std::optional<std::array<std::size_t, 3>> acceleration{};  ///< Specific force. [m/s^2]
};

/// Finds the columns of `table`: those that `named` names, the others by usual names, whatever
/// their case, spaces and units. The unit of the rates is `unit`, one of kRateUnits,
/// or if that is empty the header's. Throws
/// InputError with the names that there are: if a named column is missing, if there is no time or
/// neither attitudes nor rates, if a group isn't whole, and for rates without a unit.
Columns findColumns(const CsvTable& table, const ColumnNames& named, std::string_view unit);

}  // namespace rotatebook::recording
