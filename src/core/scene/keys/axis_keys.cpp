#include "scene/keys/axis_keys.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "base/number_text.h"
#include "base/text.h"
#include "scene/key_rows.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kNumber;
using document::TomlNode;

constexpr const char* kExpectedValues = "a list such as [10, 100, 1000]";
constexpr const char* kExpectedLabelled = "a table such as { label = \"x\", value = [4, 0, 0] }";

constexpr std::array<Named<AxisKind>, 5> kAxisKinds{{{"time", AxisKind::Time},
                                                     {"spin.longitude", AxisKind::SpinLongitude},
                                                     {"spin.latitude", AxisKind::SpinLatitude},
                                                     {"moments.smallest", AxisKind::SmallestMoment},
                                                     {"moments.middle", AxisKind::MiddleMoment}}};

bool isText(const ValueReader& value) {
  return std::holds_alternative<std::string>(value.node().value);
}

/// Returns a regular expression of keys and their parts; `N` is the number of a table.
std::string patternOf(const std::vector<std::string_view>& keys) {
  std::string pattern = "^(";
  for (const char letter : joined({keys.begin(), keys.end()}, "|"))
    pattern += letter == '.' ? "[.]" : letter == 'N' ? "[0-9]+" : std::string(1, letter);
  return pattern + ")([.][a-z0-9_]+)?$";
}

std::vector<std::string_view> variableKeys() {
  std::vector<std::string_view> names;
  for (const KeyRow& row : allKeys())
    if (row.mayVary) names.push_back(row.name);
  return names;
}

std::string valueKeyPattern() {
  return patternOf(variableKeys());
}

std::string pixelKeyPattern() {
  auto names = variableKeys();
  std::ranges::copy(namesOf(kAxisKinds), std::back_inserter(names));
  return patternOf(names);
}

/// Numbers, or with the unit of the axis's key.
constexpr ValueForm kEndForm = [] {
  ValueForm form = formOf(ValueForm::Type::Number, kNumber);
  form.kinds = kTextKind;
  return form;
}();

/// Keys of an axis that is a range.
Keys<Axis> rangeKeys() {
  static constexpr std::array keys{
      key<&Axis::key, textFrom, tomlString>(
          "key", {.type = ValueForm::Type::Text, .max = kLongestPath, .pattern = valueKeyPattern},
          {.meaning = "what varies", .byDefault = "required"}),
      key<&Axis::from, numberFrom, tomlNumber>("from", kEndForm),
      key<&Axis::to, numberFrom, tomlNumber>("to", kEndForm),
      choice<&Axis::scale, kScales>("scale"),
      key<&Axis::label, textFrom, optionalText>("label", textForm(kLongestLabel)),
  };
  return keys;
}

/// Returns the rows of rangeKeys(); its ends have no defaults.
std::vector<KeyRow> rangeRows() {
  std::vector<KeyRow> rows = membersOf<rangeKeys>();
  for (KeyRow& row : rows) {
    if (row.form.type == ValueForm::Type::Number) row.byDefault = row.value = "";
  }
  return rows;
}

/// Returns the dimension of the axis's key, if there is one.
std::optional<Dimension> dimensionOf(const ValueReader& table) {
  const auto key = table.find("key");
  const auto* name = key ? std::get_if<std::string>(&key->node().value) : nullptr;
  if (name == nullptr) return std::nullopt;
  if (*name == nameOf(kAxisKinds, AxisKind::Time)) return Dimension::Time;
  const KeyRow* row = findKey(*name);
  return row != nullptr ? row->form.dimension : std::nullopt;
}

/// Returns a field for each key of a range, whose ends may have a unit if the axis's key has any.
std::vector<Field> rangeFields(const ValueReader& table, Axis& axis) {
  const auto read = [&axis, name = table.name(), dimension = dimensionOf(table)](
                        const Key<Axis>& key, const ValueReader& value) {
    ValueForm form = key.form;
    const bool isEnd = form.type == ValueForm::Type::Number;
    if (isEnd && !dimension && isText(value)) {
      value.fail(value.name() + " must be a number, not " + describe(value.node()) + "; " + name +
                 ".key names no key that takes a unit");
    }
    if (isEnd) form.dimension = dimension;
    key.reader(value, form, axis);
  };
  return fieldsOf(rangeKeys(), read);
}

void checkRange(const ValueReader& table, const Axis& axis) {
  if (!(axis.from < axis.to)) {
    table.find("from")->fail(table.name() + " runs from " + tomlNumber(axis.from) + " to " +
                             tomlNumber(axis.to) + "; from must be less than to");
  }
  if (axis.scale == Scale::Logarithmic && !(axis.from > 0)) {
    table.find("from")->fail(table.name() + " is logarithmic, which needs from over 0, not " +
                             tomlNumber(axis.from));
  }
}

/// Returns a number that is short to write, near `value`.
double rounded(double value) {
  constexpr int kDigits = 6;
  const std::string text = roundedText(value, kDigits);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Returns the end of a range as a number.
TomlNode endNode(const ValueReader& end, double number) {
  return isText(end) ? TomlNode{number, end.node().location} : end.node();
}

/// Returns the values of a range; those between its ends are short to write.
std::vector<TomlNode> nodesOf(const ValueReader& table, const Axis& range, int count) {
  const TomlNode from = endNode(*table.find("from"), range.from);
  const TomlNode to = endNode(*table.find("to"), range.to);
  const bool isWhole = std::holds_alternative<std::int64_t>(from.value) &&
                       std::holds_alternative<std::int64_t>(to.value);
  std::vector<TomlNode> nodes{from};
  for (int i = 1; i < count - 1; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const double value = numberWithin(range.from, range.to, share, range.scale);
    TomlNode node{rounded(value), table.node().location};
    if (isWhole) node.value = static_cast<std::int64_t>(std::round(value));
    nodes.push_back(node);
  }
  nodes.push_back(to);
  return nodes;
}

/// Returns the rows of what labelled() reads.
std::vector<KeyRow> labelledRows() {
  constexpr KeyText kRequired{.byDefault = "required"};
  return {rowOf("label", kRequired, kLabelForm, ""), rowOf("value", kRequired, {}, "")};
}

AxisValue labelled(const ValueReader& table) {
  AxisValue stated;
  table.readTable({{"label", [&](const ValueReader& label) { stated.label = labelOf(label); }},
                   {"value", [&](const ValueReader& value) { stated.node = value.node(); }}});
  if (!table.find("label") || !table.find("value")) table.mismatch(kExpectedLabelled);
  stated.toml =
      "{ label = " + tomlString(stated.label) + ", value = " + tomlText(stated.node) + " }";
  return stated;
}

AxisValue axisValueFrom(const ValueReader& value) {
  const TomlNode& node = value.node();
  if (std::holds_alternative<TomlNode::Table>(node.value)) return labelled(value);
  AxisValue stated{tomlText(node), labelOf(value), std::nullopt, node};
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    stated.number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&node.value)) {
    stated.number = *real;
  }
  return stated;
}

/// Returns the values that `elements` state; `hint` follows the message about one that is twice.
std::vector<AxisValue> valuesOf(const std::vector<ValueReader>& elements, const std::string& name,
                                const char* hint) {
  std::vector<AxisValue> values;
  readEach(elements, [&](const ValueReader& element) {
    AxisValue one = axisValueFrom(element);
    if (std::ranges::count(values, one.label, &AxisValue::label) > 0) {
      element.fail(name + " has " + one.label + " twice" + hint);
    }
    values.push_back(std::move(one));
  });
  return values;
}

}  // namespace

Axis valueAxisFrom(const ValueReader& table) {
  Axis range;
  int count = 0;
  std::vector<Field> fields = rangeFields(table, range);
  fields.push_back({"values", [](const ValueReader&) {}});
  fields.push_back({"count", [&](const ValueReader& value) {
                      count = value.integer(2, static_cast<int>(kMaxRuns));
                    }});
  table.readTable(fields);
  requireKeys(table, {"key"});
  const auto list = table.find("values"), from = table.find("from"), to = table.find("to");
  const bool isRange = from && to && count > 0;
  if (list ? from || to || count > 0 || table.find("scale") : !isRange) {
    table.fail(table.name() + " needs either values, or from, to and count");
  }
  Axis axis{.key = range.key, .label = range.label};
  if (list) {
    axis.values = valuesOf(list->list(kExpectedValues), list->name(), "");
    return axis;
  }
  checkRange(table, range);
  const std::vector<TomlNode> nodes = nodesOf(table, range, count);
  std::vector<ValueReader> elements;
  for (const TomlNode& node : nodes) elements.emplace_back(node, table.name());
  axis.values =
      valuesOf(elements, table.name(), "; between whole numbers all are whole: lower count");
  return axis;
}

std::vector<KeyRow> valueAxisRows() {
  static constexpr ValueForm kValueForm{
      .kinds = {.text = true, .number = true, .flag = true, .table = true},
      .members = labelledRows};
  std::vector<KeyRow> rows = rangeRows();
  rows.push_back(rowOf("values", {}, listForm(kExpectedValues, kValueForm), ""));
  rows.push_back(rowOf("count", {.meaning = "of values between from and to"},
                       integerForm(2, static_cast<int>(kMaxRuns)), ""));
  return rows;
}

std::string valueAxisText(const Axis& axis) {
  return "{ key = " + tomlString(axis.key) +
         ", values = " + listText(axis.values, [](const AxisValue& value) { return value.toml; }) +
         (axis.label.empty() ? "" : ", label = " + tomlString(axis.label)) + " }";
}

Axis pixelAxisFrom(const ValueReader& table) {
  Axis axis;
  table.readTable(rangeFields(table, axis));
  requireKeys(table, {"key", "from", "to"});
  const auto special = std::ranges::find(kAxisKinds, axis.key, &Named<AxisKind>::name);
  if (special != kAxisKinds.end()) axis.kind = special->value;
  checkRange(table, axis);
  return axis;
}

std::vector<KeyRow> pixelAxisRows() {
  std::vector<KeyRow> rows = rangeRows();
  for (KeyRow& row : rows) {
    if (row.name == "key") row.form.pattern = pixelKeyPattern;
    if (row.form.type == ValueForm::Type::Number) row.byDefault = "required";
  }
  return rows;
}

std::string pixelAxisText(const Axis& axis) {
  return inlineTable(rangeKeys(), axis);
}

std::string labelOf(const ValueReader& value) {
  const auto& node = value.node().value;
  if (const auto* whole = std::get_if<std::int64_t>(&node)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&node)) return shortestText(*real);
  if (const bool* flag = std::get_if<bool>(&node)) return *flag ? "true" : "false";
  if (!isText(value)) {
    value.mismatch(std::string("a number, a word, or ") + kExpectedLabelled);
  }
  std::string label = value.text(kLongestLabel);
  if (label.empty()) value.mismatch("a word");
  return label;
}

void requireKeys(const ValueReader& table, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (!table.find(key)) table.fail(table.name() + " needs " + key);
  }
}

}  // namespace rotatebook::scene
