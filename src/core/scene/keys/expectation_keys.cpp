#include "scene/keys/expectation_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

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

const Keys<Expectation>& windowedBoundKeys() {
  static const Keys<Expectation> keys{
      key("min", &Expectation::min, number(kNumber)),
      key("max", &Expectation::max, number(kNumber)),
      key("rises_to", &Expectation::risesTo, number(kNumber)),
      key("falls_to", &Expectation::fallsTo, number(kNumber)),
      key("from", &Expectation::from, number(kWindowTimes)),
      {"to",
       [](const ValueReader& value, Expectation& bounds) {
         bounds.to = value.number(kWindowTimes);
       },
       // A window without an end prints no `to`.
       [](const Expectation& bounds) {
         return std::isfinite(bounds.to) ? tomlNumber(bounds.to) : "";
       },
       {}},
  };
  return keys;
}

/// Returns those of windowedBoundKeys() that know no time.
const Keys<Expectation>& timelessBoundKeys() {
  static const Keys<Expectation> keys(windowedBoundKeys().begin(), windowedBoundKeys().begin() + 2);
  return keys;
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

/// Returns the one key that holds all bounds on a quantity.
Key<std::vector<Expectation>> measureKey(Measure measure) {
  return {nameOf(measure),
          [measure](const ValueReader& value, std::vector<Expectation>& expectations) {
            readEach(value.tables(kExpectedBounds), [&](const ValueReader& bounds) {
              Expectation expectation{.measure = measure};
              readKeys(bounds, windowedBoundKeys(), expectation);
              checkWindowed(bounds, expectation);
              expectations.push_back(std::move(expectation));
            });
          },
          [measure](const std::vector<Expectation>& expectations) {
            std::vector<std::string> bounds;
            for (const Expectation& expectation : expectations) {
              if (expectation.measure != measure) continue;
              bounds.push_back(inlineTable(windowedBoundKeys(), expectation));
            }
            return bounds.size() == 1 ? bounds.front() : "[" + joined(bounds) + "]";
          },
          {.meaning = std::string(rowOf(measure).meaning),
           .byDefault = "none",
           .allowed = kExpectedBounds,
           .affects = Affects::Text}};
}

Expectation placedFrom(const ValueReader& table, const PlacedExpectations& placed) {
  Expectation one;
  std::vector<Field> fields = fieldsOf(
      placed.haveWindows ? windowedBoundKeys() : timelessBoundKeys(),
      [&](const Key<Expectation>& key, const ValueReader& value) { key.read(value, one); });
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

std::string placedText(const Expectation& one, const PlacedExpectations& placed) {
  std::string text = "{ of = " + tomlString(nameOf(one.measure)) + ", ";
  for (std::size_t i = 0; i < placed.keys.size(); ++i) {
    if (one.at[i])
      text += std::string(placed.keys[i].place) + " = " + tomlString(*one.at[i]) + ", ";
  }
  const auto& keys = placed.haveWindows ? windowedBoundKeys() : timelessBoundKeys();
  return text + inlineTable(keys, one).substr(2);
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

const Keys<std::vector<Expectation>>& expectKeys() {
  static const auto keys = [] {
    Keys<std::vector<Expectation>> all;
    for (const Measure measure : measuresOfMotions()) all.push_back(measureKey(measure));
    return all;
  }();
  return keys;
}

Measure measureFrom(const ValueReader& value, MeasureSections sections) {
  std::vector<std::string_view> names;
  std::vector<Measure> measures;
  for (const MeasureRow& row : kMeasureRows) {
    if (row.sections > sections) continue;
    names.push_back(row.name);
    measures.push_back(row.measure);
  }
  return measures[value.choice(names)];
}

Kind<std::vector<Expectation>> PlacedExpectations::kind() const {
  return tables<Expectation>(
      [placed = *this](const ValueReader& table) { return placedFrom(table, placed); },
      [placed = *this](const Expectation& one) { return placedText(one, placed); }, expected);
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

const Keys<Bounds>& boundKeys() {
  static const Keys<Bounds> keys{
      key("min", &Bounds::min, number(kNumber)),
      key("max", &Bounds::max, number(kNumber)),
  };
  return keys;
}

void checkBounds(const ValueReader& value, const Bounds& bounds) {
  if (!bounds.min && !bounds.max) value.fail(value.name() + " needs min, max or both");
  if (bounds.min && bounds.max) checkOrder(value, "min", *bounds.min, "max", *bounds.max);
}

}  // namespace rotatebook::scene
