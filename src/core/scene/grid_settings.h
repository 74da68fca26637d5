// [grid]: books side by side in rows and columns, each with other values of two keys.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/axis.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// A grid: the scene's motion with each value of one key, or each pair of values of two. At least
/// one of the axes is there.
struct GridSettings {
  std::optional<Axis> columns{}, rows{};
  std::vector<Expectation> expected{};  ///< Each of a column, a row, a cell or all.

  std::size_t columnCount() const { return columns ? columns->values.size() : 1; }
  std::size_t rowCount() const { return rows ? rows->values.size() : 1; }
  friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

/// Most cells along a side of a grid, and in all.
inline constexpr std::size_t kMaxGridSide = 12;
inline constexpr std::size_t kMaxGridCells = 96;

}  // namespace rotatebook::scene
