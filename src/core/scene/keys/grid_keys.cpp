// The keys of [grid]: the keys and values of its columns and rows, and what must come out.
#include <algorithm>
#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/sweep_values.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

constexpr const char* kExpectedGridAxis =
    "a table such as { over = \"simulation.substeps\", values = [1, 10, 100] }";
constexpr const char* kExpectedOfCells = "tables such as { column = 10, half_turns = { min = 3 } }";

/// Throws InputError if `values`, a range, runs downward: a list can.
void refuseReversed(const ValueReader& values) {
  const auto from = values.find("from"), to = values.find("to");
  if (!from || !to) return;
  const double low = from->number(document::kNumber), high = to->number(document::kNumber);
  if (low <= high) return;
  values.fail(values.name() + " runs from " + tomlNumber(low) + " to " + tomlNumber(high) +
              "; from must be less than to: swap them, or write a list");
}

GridAxis gridAxisFrom(const ValueReader& table) {
  GridAxis axis;
  table.readTable(
      {{"over", [&](const ValueReader& key) { axis.key = key.text(kLongestPath); }},
       {"values",
        [&](const ValueReader& values) {
          refuseReversed(values);
          for (StatedValue& one : statedValues(values)) axis.values.push_back(std::move(one.value));
        }},
       {"label", [&](const ValueReader& label) { axis.label = label.text(kLongestLabel); }}});
  for (const char* key : {"over", "values"}) {
    if (!table.find(key)) table.fail(table.name() + " needs " + key);
  }
  return axis;
}

std::string gridAxisText(const GridAxis& axis) {
  return "{ over = " + tomlString(axis.key) +
         ", values = " + listText(axis.values, [](const SweepValue& value) { return value.toml; }) +
         (axis.label.empty() ? "" : ", label = " + tomlString(axis.label)) + " }";
}

GridExpectation ofCellsFrom(const ValueReader& table) {
  GridExpectation one;
  std::vector<Field> fields = fieldsOf(
      expectKeys(),
      [&](const auto& key, const ValueReader& value) { key.read(value, one.expectations); });
  fields.push_back({"column", [&](const ValueReader& value) { one.column = labelOf(value); }});
  fields.push_back({"row", [&](const ValueReader& value) { one.row = labelOf(value); }});
  table.readTable(fields);
  if (one.expectations.empty()) {
    table.fail(table.name() + " needs a quantity and its bounds, such as half_turns = { min = 3 }");
  }
  return one;
}

std::string ofCellsText(const GridExpectation& one) {
  std::string text = "{ ";
  if (one.column) text += "column = " + tomlString(*one.column) + ", ";
  if (one.row) text += "row = " + tomlString(*one.row) + ", ";
  std::vector<std::string> parts;
  for (const Measure measure : measuresOfMotions()) {
    if (std::ranges::count(one.expectations, measure, &Expectation::measure) == 0) continue;
    const auto& key = expectKeys()[static_cast<std::size_t>(measure)];
    parts.push_back(std::string(key.name) + " = " + key.text(one.expectations));
  }
  return text + joined(parts) + " }";
}

void readOfCells(const ValueReader& value, GridSettings& grid) {
  // The command line may leave the cells out that something is expected of, and then that, too.
  const auto* array = std::get_if<document::TomlNode::Array>(&value.node().value);
  if (array != nullptr && array->empty()) return;
  readEach(value.tables(kExpectedOfCells),
           [&](const ValueReader& table) { grid.expected.push_back(ofCellsFrom(table)); });
}

}  // namespace

const Keys<GridSettings>& gridKeys() {
  static const Kind<GridAxis> kAxis{gridAxisFrom, gridAxisText, kExpectedGridAxis};
  static const Keys<GridSettings> keys{
      key("columns", &GridSettings::columns, kAxis,
          {.meaning =
               "the key that each column has another value of, see [below](#a-grid-of-books)",
           .byDefault = "one column"}),
      key("rows", &GridSettings::rows, kAxis,
          {.meaning = "likewise of each row", .byDefault = "one row"}),
      {"expect",
       readOfCells,
       [](const GridSettings& grid) {
         return grid.expected.empty() ? "" : listText(grid.expected, ofCellsText);
       },
       {.meaning = "bounds, as in `[expect]`, on the motions of a `column`, of a `row`, or of a "
                   "cell, which is in both",
        .byDefault = "none",
        .allowed = kExpectedOfCells,
        .affects = Affects::Text}},
  };
  return keys;
}

}  // namespace rotatebook::scene
