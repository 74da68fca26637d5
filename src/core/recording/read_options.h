// Statements about a recording.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::recording {

/// The units of rates, as options state them.
inline constexpr std::array<std::string_view, 2> kRateUnits{"rad/s", "deg/s"};
/// The units of times, as options state them.
inline constexpr std::array<std::string_view, 5> kTimeUnits{"s", "ms", "us", "ns", "min"};
/// The axes of rates beside attitudes, as options state them.
inline constexpr std::array<std::string_view, 2> kRateAxes{"world", "body"};

/// Names of columns by what they hold: {"time", "t"}, {"wx", "Gyro X"}. What a column holds is one
/// of columnRoles(). An empty name leaves out what belongs to it: attitudes, for {"qw", ""}.
using ColumnNames = std::vector<std::pair<std::string, std::string>>;

/// Statements about a recording that its file doesn't make.
struct ReadOptions {
  ColumnNames columns{};               ///< Of the columns without a usual name.
  std::string unit{};                  ///< Of rates, one of kRateUnits; if empty, the header's.
  std::string timeUnit{};              ///< One of kTimeUnits; if empty, the header's.
  std::string ratesAlong{};            ///< One of kRateAxes; if empty, by the columns' names.
  std::optional<double> from{}, to{};  ///< The part to take, of the file's times. [s]
  Eigen::Vector3d bias{0, 0, 0};       ///< Subtracted from rates along the body's axes. [rad/s]

  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

}  // namespace rotatebook::recording
