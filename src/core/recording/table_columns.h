// The columns of a recording.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace rotatebook::recording {

/// The columns of a table, by their indices. A group is there as a whole, or not at all.
struct Columns {
  std::size_t time = 0;
  std::optional<std::size_t> nanoseconds{};                  ///< To be added to the time.
  double secondsPerUnit = 1;                                 ///< Of the time. [s]
  bool isTimeUnitStated = false;                             ///< Else it is taken for seconds.
  std::optional<std::array<std::size_t, 4>> quaternion{};    ///< w, x, y, z; world from body.
  std::optional<std::array<std::size_t, 9>> matrix{};        ///< Row by row; world from body.
  std::optional<std::array<std::size_t, 3>> rates{};         ///< Angular velocity.
  bool areRatesAlongBody = true;                             ///< Else along the world's axes.
  double radiansPerUnit = 1;                                 ///< Of the rates. [rad]
  std::optional<std::array<std::size_t, 3>> acceleration{};  ///< Specific force.
};

}  // namespace rotatebook::recording
