// Reads and prints [grid], books side by side with other values of two keys.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_name.h"
#include "document/problems.h"
#include "scene/keys/keys.h"
#include "scene/sections.h"
#include "scene/varied_motion.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr std::string_view kTilt = "initial.tilt";

/// An axis as it is read; an axis that is missing has one value, which changes nothing.
struct ReadGridAxis {
  std::optional<ValueReader> table{};
  std::optional<VariedKey> varied{};
  std::string path{};  ///< The key, "initial.tilt.0" for a tilt's angle.

  std::size_t count() const { return varied ? varied->values.size() : 1; }
};

bool isAngle(const TomlNode& node) {
  return !std::holds_alternative<TomlNode::Array>(node.value);
}

/// Takes "initial.tilt" with an angle as the angle of the scene's tilt, whose axis stays.
std::string pathOf(const VariedKey& varied, const ValueReader& file) {
  const std::string key = varied.key.text(kLongestPath);
  const bool isOfTilt = key == kTilt || key.starts_with(std::string(kTilt) + ".");
  const auto tilt = file.find("initial", "tilt");
  const bool isWhole =
      key == kTilt && !std::ranges::all_of(varied.values, isAngle, &StatedValue::node);
  if (!isOfTilt || isWhole) return key;
  if (!tilt) {
    varied.key.fail(key + " is a part of initial.tilt, which the scene doesn't state; state it, " +
                    "such as initial.tilt = [0.01, \"z\"]");
  }
  return key == kTilt ? key + ".0" : key;
}

ReadGridAxis readAxis(const ValueReader& section, const char* name, const ValueReader& file) {
  const auto table = section.find(name);
  if (!table) return {};
  ReadGridAxis read{table, variedKeyFrom(*table), {}};
  read.path = pathOf(*read.varied, file);
  if (read.path == "simulation.time_per_frame") {
    read.varied->key.fail(
        "the books of a grid have no time_per_frame of their own, because all share one clock; "
        "vary simulation.step, the length of a step");
  }
  if (read.count() <= kMaxGridSide) return read;
  table->find("values")->fail(table->name() + " has " + std::to_string(read.count()) +
                              " values; a side of a grid has up to " +
                              std::to_string(kMaxGridSide));
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
  if (axis.varied) put(sections, axis.path, *axis.varied, axis.varied->values[index]);
}

/// Returns "substeps 10", a value with the last word of its key; empty without an axis.
std::string labelAt(const std::optional<GridAxis>& axis, std::size_t index) {
  if (!axis) return "";
  std::string_view key = axis->key;
  if (key.starts_with(kTilt)) key = "tilt";
  return std::string(key.substr(key.rfind('.') + 1)) + " " + axis->values[index].label;
}

bool isAt(const std::optional<std::string>& wanted, const std::optional<GridAxis>& axis,
          std::size_t index) {
  return !wanted || (axis && axis->values[index].label == *wanted);
}

/// Returns what the scene expects of all motions, and [grid] of this cell.
std::vector<Expectation> expectedAt(const Scene& scene, std::size_t column, std::size_t row) {
  std::vector<Expectation> all = scene.expectations;
  for (const GridExpectation& one : scene.grid->expected) {
    if (!isAt(one.column, scene.grid->columns, column) || !isAt(one.row, scene.grid->rows, row)) {
      continue;
    }
    all.insert(all.end(), one.expectations.begin(), one.expectations.end());
  }
  return all;
}

/// Makes a panel of each cell, row by row.
void makePanels(const ReadGridAxis& columns, const ReadGridAxis& rows, const ValueReader& file,
                Scene& scene) {
  const bool hasColumns = columns.varied.has_value();
  const ReadGridAxis &inner = hasColumns ? columns : rows, &outer = hasColumns ? rows : columns;
  document::Problems problems;
  for (std::size_t i = 0; i < outer.count(); ++i) {
    TomlNode sections = motionPart(file);
    problems.note([&] { putAt(sections, outer, i); });
    const VariedMotions motions(sections, scene.simulation, *inner.varied, inner.path);
    for (std::size_t j = 0; j < inner.count(); ++j) {
      const std::size_t column = hasColumns ? j : i, row = hasColumns ? i : j;
      problems.note([&] {
        Panel& panel = scene.panels.emplace_back();
        static_cast<Motion&>(panel) = motions.with(inner.varied->values[j]);
        panel.expectations = expectedAt(scene, column, row);
        panel.label =
            joined({labelAt(scene.grid->columns, column), labelAt(scene.grid->rows, row)});
      });
    }
  }
  problems.throwIfAny();
}

/// Throws InputError if a key changes nothing in any of the motions.
void refuseUnusedKey(const ReadGridAxis& axis, const Scene& scene) {
  if (!axis.varied) return;
  refuseUnused(axis.varied->key, axis.path, modelsOf(scene.panels), "books");
}

void requireCell(const ValueReader& table, const char* side, const std::optional<GridAxis>& axis) {
  const auto value = table.find(side);
  if (!value) return;
  if (!axis) value->fail(value->name() + " needs grid." + side + "s");
  const std::string label = labelOf(*value);
  std::vector<std::string_view> labels;
  for (const SweepValue& one : axis->values) labels.push_back(one.label);
  if (std::ranges::count(labels, label) > 0) return;
  value->fail(value->name() + " = " + label + " is no value of grid." + side + "s" +
              didYouMean(label, labels));
}

void checkCells(const ValueReader& section, const GridSettings& grid) {
  if (grid.expected.empty()) return;
  for (const ValueReader& table : section.find("expect")->tables("")) {
    requireCell(table, "column", grid.columns);
    requireCell(table, "row", grid.rows);
  }
}

void refuseManySamples(const ValueReader& section, const Scene& scene) {
  const auto samples = static_cast<std::int64_t>(scene.panels.size()) * scene.clip.frameCount();
  if (samples <= kMaxGridSamples) return;
  section.fail("the books of [grid] have " + std::to_string(samples) +
               " frames together; the limit is " + std::to_string(kMaxGridSamples) +
               ": lower clip.duration, or make fewer books");
}

}  // namespace

void readGrid(const ValueReader& section, const ValueReader& file, Scene& scene) {
  refuseOtherSections(file);
  readKeys(section, gridKeys(), scene.grid.emplace());
  if (!section.find("columns") && !section.find("rows")) {
    section.fail(
        "[grid] needs columns or rows, such as columns = { over = "
        "\"simulation.substeps\", values = [1, 10, 100] }");
  }
  const ReadGridAxis columns = readAxis(section, "columns", file);
  const ReadGridAxis rows = readAxis(section, "rows", file);
  refuseSize(section, columns.count(), rows.count());
  if (columns.path == rows.path) {
    rows.varied->key.fail(rows.varied->key.name() + " is grid.columns.over, too; name another key");
  }
  checkCells(section, *scene.grid);
  makePanels(columns, rows, file, scene);
  refuseUnusedKey(columns, scene);
  refuseUnusedKey(rows, scene);
  refuseManySamples(section, scene);
}

std::string gridText(const Scene& scene, Printed printed) {
  return scene.grid ? "\n[grid]\n" + linesOf(gridKeys(), *scene.grid, printed) : "";
}

}  // namespace rotatebook::scene
