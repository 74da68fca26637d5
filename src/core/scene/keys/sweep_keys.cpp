// The keys of [study] for a sweep: a study over any key of a motion.
#include <algorithm>
#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/sweep_values.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

constexpr const char* kExpectedMeasures = "a list of quantities, such as [\"diverges_at\"]";
constexpr const char* kExpectedSweepBounds =
    "tables such as { measure = \"diverges_at\", at = 10, min = 20 }";

std::string keyFrom(const ValueReader& value) {
  return value.text(kLongestPath);
}

std::vector<SweepValue> valuesFrom(const ValueReader& value) {
  std::vector<SweepValue> values;
  for (StatedValue& one : statedValues(value)) values.push_back(std::move(one.value));
  return values;
}

std::string valuesText(const std::vector<SweepValue>& values) {
  return listText(values, [](const SweepValue& value) { return value.toml; });
}

SweepKey curvesFrom(const ValueReader& value) {
  SweepKey curves;
  value.readTable({{"over", [&](const ValueReader& key) { curves.key = keyFrom(key); }},
                   {"values", [&](const ValueReader& list) { curves.values = valuesFrom(list); }}});
  if (!value.find("over") || !value.find("values")) {
    value.fail(value.name() + " needs over and values");
  }
  return curves;
}

Measure motionMeasureFrom(const ValueReader& value) {
  std::vector<std::string_view> names;
  for (const Measure measure : measuresOfMotions()) names.push_back(nameOf(measure));
  return measuresOfMotions()[value.choice(names)];
}

std::vector<Measure> measuresFrom(const ValueReader& value) {
  std::vector<Measure> measures;
  readEach(value.list(kExpectedMeasures), [&](const ValueReader& element) {
    const Measure measure = motionMeasureFrom(element);
    if (std::ranges::count(measures, measure) > 0) {
      element.fail(value.name() + " has " + std::string(nameOf(measure)) + " twice");
    }
    measures.push_back(measure);
  });
  if (measures.size() <= kMaxMeasures) return measures;
  value.fail(value.name() + " has " + std::to_string(measures.size()) +
             " quantities; a study measures up to " + std::to_string(kMaxMeasures));
}

SweepExpectation expectationFrom(const ValueReader& table) {
  SweepExpectation one;
  std::vector<Field> fields{
      {"measure", [&](const ValueReader& value) { one.measure = motionMeasureFrom(value); }},
      {"at", [&](const ValueReader& value) { one.at = labelOf(value); }},
      {"curve", [&](const ValueReader& value) { one.curve = labelOf(value); }}};
  const std::vector<Field> bounds = boundFields(one.bounds);
  fields.insert(fields.end(), bounds.begin(), bounds.end());
  table.readTable(fields);
  if (!table.find("measure")) table.fail(table.name() + " needs measure");
  checkBounds(table, one.bounds);
  return one;
}

void readExpected(const ValueReader& value, Scene& scene) {
  // The command line may leave the runs out that something is expected of, and then that, too.
  const auto* array = std::get_if<document::TomlNode::Array>(&value.node().value);
  if (array != nullptr && array->empty()) return;
  readEach(value.tables(kExpectedSweepBounds), [&](const ValueReader& table) {
    scene.study->sweep->expected.push_back(expectationFrom(table));
  });
}

std::string expectationText(const SweepExpectation& one) {
  std::string text = "{ measure = " + tomlString(nameOf(one.measure));
  if (one.at) text += ", at = " + tomlString(*one.at);
  if (one.curve) text += ", curve = " + tomlString(*one.curve);
  return text + ", " + inlineTable(boundKeys(), one.bounds).substr(2);
}

/// Returns a function that prints a part of a scene's sweep; nothing of other studies.
template <typename Text>
auto ofSweep(Text text) {
  return [text](const Scene& scene) -> std::string {
    return scene.study && scene.study->sweep ? text(*scene.study->sweep) : "";
  };
}

}  // namespace

const Keys<Scene>& sweepKeys() {
  static const Keys<Scene> keys{
      {"over",
       [](const ValueReader& value, Scene& scene) {
         scene.study->sweep->over.key = keyFrom(value);
       },
       ofSweep([](const Sweep& sweep) { return tomlString(sweep.over.key); }),
       {.meaning = "instead of all these: the key that each run has another value of",
        .byDefault = "none",
        .allowed = "a key of `[body]`, `[simulation]`, `[initial]` or `[[nudge]]`, such as "
                   "\"simulation.substeps\""}},
      {"values",
       [](const ValueReader& value, Scene& scene) {
         scene.study->sweep->over.values = valuesFrom(value);
       },
       ofSweep([](const Sweep& sweep) { return valuesText(sweep.over.values); }),
       {.meaning = "its values, see [below](#a-study-over-any-key)",
        .byDefault = "required with `over`",
        .allowed = "a list, or a range such as `{ from = 1, to = 100, count = 5 }`"}},
      {"measure",
       [](const ValueReader& value, Scene& scene) {
         scene.study->sweep->measures = measuresFrom(value);
       },
       ofSweep([](const Sweep& sweep) {
         return listText(sweep.measures, [](Measure one) { return tomlString(nameOf(one)); });
       }),
       {.meaning = "one to three of the [quantities](#expectations) to measure",
        .byDefault = "required with `over`",
        .allowed = kExpectedMeasures}},
      {"curves",
       [](const ValueReader& value, Scene& scene) {
         scene.study->sweep->curves = curvesFrom(value);
       },
       ofSweep([](const Sweep& sweep) -> std::string {
         if (!sweep.curves) return "";
         return "{ over = " + tomlString(sweep.curves->key) +
                ", values = " + valuesText(sweep.curves->values) + " }";
       }),
       {.meaning = "a second key: one curve for each of its values",
        .byDefault = "none",
        .allowed = "`{ over = KEY, values = ... }`, as above"}},
      {"expect",
       readExpected,
       ofSweep([](const Sweep& sweep) -> std::string {
         return sweep.expected.empty() ? "" : listText(sweep.expected, expectationText);
       }),
       {.meaning = "bounds on a quantity, of all runs or of those `at` a value or on a `curve`",
        .byDefault = "none",
        .allowed = kExpectedSweepBounds,
        .affects = Affects::Text}},
  };
  return keys;
}

}  // namespace rotatebook::scene
