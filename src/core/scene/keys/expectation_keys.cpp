#include "scene/keys/expectation_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "base/nearest_name.h"
#include "base/text.h"
#include "scene/keys/axis_keys.h"
#include "scene/keys/kinds.h"

namespace rotatebook::scene {
namespace {

using document::kNumber;

constexpr const char* kExpectedBounds = "a table such as { min = 1.0 } or an array of them";
constexpr NumberRange kWindowTimes{"zero or a positive number", 0,
                                   std::numeric_limits<double>::max(), Dimension::Time};

/// Returns the end of a window; nothing if it has none.
std::string endText(double end) {
  return std::isfinite(end) ? tomlNumber(end) : "";
}

/// Keys of bounds; with a window, and what is reached in it, if `haveWindows`.
Keys<Expectation> boundKeysOf(bool haveWindows) {
  static constexpr std::array keys{
      number<&Expectation::min>("min", kNumber),
      number<&Expectation::max>("max", kNumber),
      number<&Expectation::risesTo>("rises_to", kNumber),
      number<&Expectation::fallsTo>("falls_to", kNumber),
      number<&Expectation::from>("from", kWindowTimes),
      key<&Expectation::to, numberFrom, endText>("to",
                                                 formOf(ValueForm::Type::Number, kWindowTimes)),
  };
  return Keys<Expectation>(keys).first(haveWindows ? keys.size() : 2);
}

void checkOrder(const ValueReader& bounds, std::string_view lowKey, double low,
                std::string_view highKey, double high) {
  if (low <= high) return;
  bounds.find(lowKey)->mismatch("at most " + std::string(highKey) + ", " + tomlNumber(high));
}

void checkWindowed(const ValueReader& bounds, const Expectation& expectation) {
  if (!expectation.min && !expectation.max && !expectation.risesTo && !expectation.fallsTo) {
    bounds.fail(bounds.name() + " needs at least one of min, max, rises_to and falls_to");
  }
  if (expectation.min && expectation.max) checkBounds(bounds, expectation.bounds());
  checkOrder(bounds, "from", expectation.from, "to", expectation.to);
}

template <bool kHaveWindows>
Keys<Expectation> boundKeysWith() {
  return boundKeysOf(kHaveWindows);
}

template <Measure kMeasure>
void readBounds(const ValueReader& value, std::vector<Expectation>& expectations) {
  readEach(value.tables(kExpectedBounds), [&](const ValueReader& bounds) {
    Expectation expectation{.measure = kMeasure};
    readKeys(bounds, boundKeysOf(true), expectation);
    checkWindowed(bounds, expectation);
    expectations.push_back(std::move(expectation));
  });
}

template <Measure kMeasure>
std::string boundsText(const std::vector<Expectation>& expectations) {
  std::vector<std::string> bounds;
  for (const Expectation& expectation : expectations) {
    if (expectation.measure != kMeasure) continue;
    bounds.push_back(inlineTable(boundKeysOf(true), expectation));
  }
  return bounds.size() == 1 ? bounds.front() : "[" + joined(bounds) + "]";
}

/// Returns the one key that holds all bounds on a quantity.
template <Measure kMeasure>
constexpr auto measureKey() {
  return keyOf<std::vector<Expectation>, readBounds<kMeasure>, boundsText<kMeasure>>(
      nameOf(kMeasure),
      tableForm({.list = true, .table = true}, kExpectedBounds, membersOf<boundKeysWith<true>>),
      {.meaning = rowOf(kMeasure).meaning, .byDefault = "none", .affects = Affects::Text});
}

Expectation expectationFrom(const ValueReader& table, const PlacedExpectations& placed) {
  Expectation one;
  std::vector<Field> fields = fieldsInto(one, boundKeysOf(placed.haveWindows));
  fields.push_back(
      {"of", [&](const ValueReader& value) { one.measure = measureFrom(value, placed.measures); }});
  for (std::size_t i = 0; i < placed.keys.size(); ++i) {
    fields.push_back({placed.keys[i].place,
                      [&one, i](const ValueReader& value) { one.at[i] = labelOf(value); }});
  }
  table.readTable(fields);
  requireKeys(table, {"of"});
  if (placed.haveWindows) {
    checkWindowed(table, one);
  } else {
    checkBounds(table, one.bounds());
  }
  return one;
}

std::string expectationText(const Expectation& one, const PlacedExpectations& placed) {
  std::string text = "{ of = " + tomlString(nameOf(one.measure)) + ", ";
  for (std::size_t i = 0; i < placed.keys.size(); ++i) {
    if (one.at[i])
      text += std::string(placed.keys[i].place) + " = " + tomlString(*one.at[i]) + ", ";
  }
  return text + inlineTable(boundKeysOf(placed.haveWindows), one).substr(2);
}

void requireLabel(const ValueReader& value, const Axis& axis, const std::string& axisName) {
  const std::string label = labelOf(value);
  std::vector<std::string_view> labels;
  for (const AxisValue& one : axis.values) labels.push_back(one.label);
  if (std::ranges::count(labels, label) > 0) return;
  const bool isWord = std::holds_alternative<std::string>(value.node().value);
  value.fail(value.name() + " = " + label + " is no value of " + axisName +
             (isWord ? didYouMean(label, labels) : ""));
}

}  // namespace

Keys<std::vector<Expectation>> expectKeys() {
  static constexpr auto keys = []<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
    return std::array{measureKey<kMeasuresOfMotions[kIndices]>()...};
  }
  (std::make_index_sequence<kMeasuresOfMotions.size()>());
  return keys;
}

Measure measureFrom(const ValueReader& value, MeasureSections sections) {
  return static_cast<Measure>(value.choice(measureNames(sections)));
}

std::vector<KeyRow> PlacedExpectations::rows() const {
  std::vector<KeyRow> rows = rowsOf("", boundKeysOf(haveWindows));
  rows.push_back(rowOf("of", {.meaning = "the measure", .byDefault = "required"},
                       {.type = ValueForm::Type::Choice, .choices = measureNames(measures)}, ""));
  for (const PlaceKeys& key : keys)
    rows.push_back(rowOf(key.place, {.meaning = "a value of the axis"}, kLabelForm, ""));
  return rows;
}

std::vector<Expectation> PlacedExpectations::read(const ValueReader& value) const {
  return tablesFrom(value, expected,
                    [this](const ValueReader& table) { return expectationFrom(table, *this); });
}

std::string PlacedExpectations::text(const std::vector<Expectation>& all) const {
  return tablesText(all, [this](const Expectation& one) { return expectationText(one, *this); });
}

void PlacedExpectations::check(const ValueReader& section,
                               const std::array<const Axis*, 2>& axes) const {
  const auto value = section.find("expect");
  const auto isNone = [](const document::TomlNode& node) {
    const auto* array = std::get_if<document::TomlNode::Array>(&node.value);
    return array != nullptr && array->empty();
  };
  if (!value || isNone(value->node())) return;
  for (const ValueReader& table : value->tables(expected)) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto place = table.find(keys[i].place);
      if (!place) continue;
      const std::string axis = section.name() + "." + keys[i].axis;
      if (axes[i] == nullptr) place->fail(place->name() + " needs " + axis);
      requireLabel(*place, *axes[i], axis);
    }
  }
}

Keys<Bounds> boundKeys() {
  static constexpr std::array keys{
      number<&Bounds::min>("min", kNumber),
      number<&Bounds::max>("max", kNumber),
  };
  return keys;
}

void checkBounds(const ValueReader& value, const Bounds& bounds) {
  if (!bounds.min && !bounds.max) value.fail(value.name() + " needs min, max or both");
  if (bounds.min && bounds.max) checkOrder(value, "min", *bounds.min, "max", *bounds.max);
}

}  // namespace rotatebook::scene
