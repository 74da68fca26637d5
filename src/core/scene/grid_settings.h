// [grid]: books side by side in rows and columns, each with other values of two keys.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/expectation.h"
#include "scene/study_settings.h"

namespace rotatebook::scene {

/// A key of a motion and its values: one for each column from the left, or for each row from the
/// top.
struct GridAxis : SweepKey {
  std::string label{};  ///< In the margin; empty for the key and its unit.

  friend bool operator==(const GridAxis&, const GridAxis&) = default;
};

/// Bounds on the motions of some cells.
struct GridExpectation {
  std::optional<std::string> column{};  ///< The label of a column's value; without it, all.
  std::optional<std::string> row{};     ///< Likewise of a row's.
  std::vector<Expectation> expectations{};

  friend bool operator==(const GridExpectation&, const GridExpectation&) = default;
};

/// A grid: the scene's motion with each value of one key, or each pair of values of two. At least
/// one of the axes is there.
struct GridSettings {
  std::optional<GridAxis> columns{}, rows{};
  std::vector<GridExpectation> expected{};

  std::size_t columnCount() const { return columns ? columns->values.size() : 1; }
  std::size_t rowCount() const { return rows ? rows->values.size() : 1; }
  friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

/// Most cells along a side of a grid, and in all.
inline constexpr std::size_t kMaxGridSide = 12;
inline constexpr std::size_t kMaxGridCells = 96;

/// Returns a key with its unit, if it has one: "initial.tilt.0  [rad]".
std::string keyWithUnit(const std::string& key);
/// Returns the name of an axis: its key, with the unit of its numbers.
std::string nameOf(const SweepKey& axis);
/// Returns the name of an axis for its margin: its label, or that of its key.
std::string nameOf(const GridAxis& axis);

}  // namespace rotatebook::scene
