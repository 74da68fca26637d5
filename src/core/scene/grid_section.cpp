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

using document::TomlNode;

/// An axis as it is read; an axis that is missing has one value, which changes nothing.
struct ReadGridAxis {
  std::optional<ValueReader> table{};
  std::optional<VariedKey> varied{};

  std::size_t count() const { return varied ? varied->values.size() : 1; }
};

ReadGridAxis readAxis(const ValueReader& section, const char* name, const ValueReader& file) {
  const auto table = section.find(name);
  if (!table) return {};
  const ReadGridAxis read{table, variedKeyFrom(*table, file)};
  if (read.varied->path == "simulation.time_per_frame") {
    read.varied->key.fail(
        "the books of a grid have no time_per_frame of their own, because all share one clock; "
        "vary simulation.step, the length of a step");
  }
  if (read.count() <= kMaxGridSide) return read;
  table->fail(table->name() + " has " + std::to_string(read.count()) +
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

void putAt(TomlNode& sections, const ReadGridAxis& axis, std::size_t index) {
  if (axis.varied) put(sections, *axis.varied, axis.varied->values[index]);
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

/// Returns the motion of each cell, row by row.
std::vector<Panel> motionsOfCells(const ReadGridAxis& columns, const ReadGridAxis& rows,
                                  const ValueReader& file, const Spec& spec, Shared& shared) {
  const bool hasColumns = columns.varied.has_value();
  const ReadGridAxis &inner = hasColumns ? columns : rows, &outer = hasColumns ? rows : columns;
  std::vector<Panel> cells;
  document::Problems problems;
  for (std::size_t i = 0; i < outer.count(); ++i) {
    TomlNode sections = motionPart(file);
    problems.note([&] { putAt(sections, outer, i); });
    const VariedMotions motions(sections, shared, *inner.varied);
    for (std::size_t j = 0; j < inner.count(); ++j) {
      const std::size_t column = hasColumns ? j : i, row = hasColumns ? i : j;
      problems.note([&] {
        Panel& panel = cells.emplace_back();
        static_cast<Motion&>(panel) = motions.with(inner.varied->values[j]);
        panel.expectations = expectedAt(spec, column, row);
        panel.label = joined({labelAt(spec.grid->columns, column), labelAt(spec.grid->rows, row)});
      });
    }
  }
  problems.throwIfAny();
  return cells;
}

/// Throws InputError if a key changes nothing in any of the motions.
void refuseUnusedKey(const ReadGridAxis& axis, const std::vector<Panel>& cells) {
  if (!axis.varied) return;
  refuseUnused(axis.varied->key, axis.varied->path, modelsOf(cells), "books");
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
  const ReadGridAxis columns = readAxis(section, "columns", file);
  const ReadGridAxis rows = readAxis(section, "rows", file);
  refuseSize(section, columns.count(), rows.count());
  if (columns.varied && rows.varied && columns.varied->path == rows.varied->path) {
    rows.varied->key.fail(rows.varied->key.name() + " is grid.columns.key, too; name another key");
  }
  const auto axisIn = [](const std::optional<Axis>& axis) { return axis ? &*axis : nullptr; };
  kGridExpectations.check(section, {axisIn(grid.columns), axisIn(grid.rows)});
  refuseManySamples(section, columns.count() * rows.count(), clip);
  return grid;
}

std::vector<Panel> cellsOf(const Spec& spec, const ValueReader& file, Shared& shared) {
  const ValueReader section = *file.find("grid");
  const ReadGridAxis columns = readAxis(section, "columns", file);
  const ReadGridAxis rows = readAxis(section, "rows", file);
  std::vector<Panel> cells = motionsOfCells(columns, rows, file, spec, shared);
  refuseUnusedKey(columns, cells);
  refuseUnusedKey(rows, cells);
  return cells;
}

std::string gridText(const Spec& spec, const Printed& printed) {
  return spec.grid ? "\n[grid]\n" + linesOf(gridKeys(), *spec.grid, printed) : "";
}

}  // namespace rotatebook::scene
