// Reads and prints [grid], books side by side with other values of two keys.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/document/problems.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

/// Completes an axis of `section`, if there is one.
void finishSide(const ValueReader& section, const char* name, const ValueReader& file,
                std::optional<Axis>& axis) {
  if (!axis) return;
  const ValueReader table = *section.find(name);
  finishAxis(table, file, *axis);
  if (axis->key == "simulation.time_per_frame") {
    table.find("key")->fail(
        "the books of a grid have no time_per_frame of their own, because all share one clock; "
        "vary simulation.step, the length of a step");
  }
  if (axis->values.size() <= kMaxGridSide) return;
  table.fail(table.name() + " has " + std::to_string(axis->values.size()) +
             " values; a side of a grid has up to " + std::to_string(kMaxGridSide));
}

void refuseSize(const ValueReader& section, std::size_t columns, std::size_t rows) {
  const std::size_t cells = columns * rows;
  if (cells < kMinPanels) {
    section.fail("[grid] has a single book; give columns or rows more values, or leave it out");
  }
  if (cells <= kMaxGridCells) return;
  section.fail("[grid] has " + std::to_string(columns) + " columns and " + std::to_string(rows) +
               " rows, " + std::to_string(cells) + " books; the limit is " +
               std::to_string(kMaxGridCells) + ", such as 12 columns and 8 rows");
}

/// Refuses what has motions of its own.
void refuseOtherSections(const ValueReader& file) {
  const auto refuse = [&](const char* section, const std::string& problem) {
    if (const auto other = file.find(section)) other->fail(problem);
  };
  refuse("panel",
         "the scene has both [[panel]] and [grid], which say what books are side by side; "
         "keep one of them");
  refuse("study",
         "the scene has both [study] and [grid]; a study is of a single motion: leave one "
         "of them out, or make another scene of it");
  refuse("map",
         "the scene has both [map] and [grid]; a map varies keys itself: leave one of them "
         "out, or make another scene of it");
}

const Axis* axisIn(const std::optional<Axis>& axis) {
  return axis ? &*axis : nullptr;
}

/// Returns "substeps 10", a value with the last word of its key; empty without an axis.
std::string labelAt(const std::optional<Axis>& axis, std::size_t index) {
  if (!axis) return "";
  std::string_view key = axis->key;
  if (key.starts_with("initial.tilt")) key = "tilt";
  return std::string(key.substr(key.rfind('.') + 1)) + " " + axis->values[index].label;
}

bool isAt(const std::optional<std::string>& wanted, const std::optional<Axis>& axis,
          std::size_t index) {
  return !wanted || (axis && axis->values[index].label == *wanted);
}

/// Returns what the scene expects of all motions, and [grid] of this cell.
std::vector<Expectation> expectedAt(const Spec& spec, std::size_t column, std::size_t row) {
  std::vector<Expectation> all = spec.motion.expectations;
  for (Expectation one : spec.grid->expected) {
    if (!isAt(one.at[0], spec.grid->columns, column) || !isAt(one.at[1], spec.grid->rows, row)) {
      continue;
    }
    one.at = {};
    all.push_back(std::move(one));
  }
  return all;
}

void refuseManySamples(const ValueReader& section, std::size_t cells, const ClipSettings& clip) {
  const auto samples = static_cast<std::int64_t>(cells) * clip.frameCount();
  if (samples <= kMaxGridSamples) return;
  section.fail("the books of [grid] have " + std::to_string(samples) +
               " frames together; the limit is " + std::to_string(kMaxGridSamples) +
               ": lower clip.duration, or make fewer books");
}

}  // namespace

GridSettings readGrid(const ValueReader& section, const ValueReader& file,
                      const ClipSettings& clip) {
  refuseOtherSections(file);
  GridSettings grid;
  readKeys(section, gridKeys(), grid);
  if (!section.find("columns") && !section.find("rows")) {
    section.fail(
        "[grid] needs columns or rows, such as columns = { key = "
        "\"simulation.substeps\", values = [1, 10, 100] }");
  }
  finishSide(section, "columns", file, grid.columns);
  finishSide(section, "rows", file, grid.rows);
  refuseSize(section, grid.columnCount(), grid.rowCount());
  if (grid.columns && grid.rows && variedKey(*grid.columns) == variedKey(*grid.rows))
    section.find("rows", "key")->fail("grid.rows.key is grid.columns.key, too; name another key");
  kGridExpectations.check(section, {axisIn(grid.columns), axisIn(grid.rows)});
  refuseManySamples(section, grid.columnCount() * grid.rowCount(), clip);
  return grid;
}

std::vector<Panel> readCells(const ValueReader& file, const Spec& spec) {
  const PlacedAxis rows{axisIn(spec.grid->rows), spec.locations.of({"grid.rows.key"})};
  const PlacedAxis columns{axisIn(spec.grid->columns), spec.locations.of({"grid.columns.key"})};
  std::vector<Panel> cells;
  readVaried(file, rows, columns, [&](std::size_t row, std::size_t column, Motion motion) {
    motion.expectations = expectedAt(spec, column, row);
    cells.push_back({std::move(motion),
                     joined({labelAt(spec.grid->columns, column), labelAt(spec.grid->rows, row)})});
  });
  return cells;
}

void checkCells(const Scene& scene) {
  const std::vector<physics::Model> models = modelsOf(scene.motions);
  const auto check = [&](const std::optional<Axis>& axis, const char* key) {
    if (axis) refuseUnused(scene.locations.of({key}), axis->key, models, "books");
  };
  check(scene.grid->columns, "grid.columns.key");
  check(scene.grid->rows, "grid.rows.key");
}

std::string gridText(const Spec& spec, const Printed& printed) {
  return spec.grid ? "\n[grid]\n" + linesOf(gridKeys(), *spec.grid, printed) : "";
}

}  // namespace rotatebook::scene
