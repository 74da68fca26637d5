#include "scene/keys/sweep_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/number_text.h"
#include "document/toml_text.h"
#include "scene/keys/key.h"
#include "scene/keys/kinds.h"
#include "scene/scale.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr const char* kExpectedValues =
    "a list such as [10, 100, 1000] or a range such as { from = 1, to = 100, count = 5 }";
constexpr const char* kExpectedLabelled = "a table such as { label = \"x\", value = [4, 0, 0] }";

constexpr std::array<Named<Scale>, 2> kSpacings{{
    {"linear", Scale::Linear},
    {"logarithmic", Scale::Logarithmic},
}};

/// A range of numbers.
struct Range {
  std::optional<TomlNode> from{}, to{};
  double low = 0, high = 0;
  int count = 0;
  Scale spacing = Scale::Linear;

  bool isWhole() const {
    return std::holds_alternative<std::int64_t>(from->value) &&
           std::holds_alternative<std::int64_t>(to->value);
  }
};

Range rangeFrom(const ValueReader& value) {
  Range range;
  value.readTable({{"from",
                    [&](const ValueReader& end) {
                      range.low = end.number(document::kNumber);
                      range.from = end.node();
                    }},
                   {"to",
                    [&](const ValueReader& end) {
                      range.high = end.number(document::kNumber);
                      range.to = end.node();
                    }},
                   {"count",
                    [&](const ValueReader& count) {
                      range.count = count.integer(2, static_cast<int>(kMaxRuns));
                    }},
                   {"spacing", [&](const ValueReader& spacing) {
                      range.spacing = choiceFrom(spacing, kSpacings);
                    }}});
  if (!range.from || !range.to || range.count == 0) {
    value.fail(value.name() + " needs from, to and count");
  }
  if (range.spacing == Scale::Logarithmic && !(range.low > 0 && range.high > 0)) {
    value.fail(value.name() + " is logarithmic, which needs from and to over 0");
  }
  return range;
}

/// Returns a number that is short to write, near `value`.
double rounded(double value) {
  constexpr int kDigits = 6;
  const std::string text = roundedText(value, kDigits);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Returns the `i`-th number strictly within the range.
double numberWithin(const Range& range, int i) {
  const double share = static_cast<double>(i) / (range.count - 1);
  return numberWithin(range.low, range.high, share, range.spacing);
}

std::vector<TomlNode> nodesOf(const Range& range, const std::string& location) {
  std::vector<TomlNode> nodes{*range.from};
  for (int i = 1; i < range.count - 1; ++i) {
    const double number = numberWithin(range, i);
    TomlNode node{rounded(number), location};
    if (range.isWhole()) node.value = static_cast<std::int64_t>(std::round(number));
    nodes.push_back(node);
  }
  nodes.push_back(*range.to);
  return nodes;
}

StatedValue labelled(const ValueReader& table) {
  StatedValue stated;
  table.readTable(
      {{"label", [&](const ValueReader& label) { stated.value.label = labelOf(label); }},
       {"value", [&](const ValueReader& value) { stated.node = value.node(); }}});
  if (!table.find("label") || !table.find("value")) table.mismatch(kExpectedLabelled);
  stated.value.toml =
      "{ label = " + tomlString(stated.value.label) + ", value = " + tomlText(stated.node) + " }";
  return stated;
}

StatedValue statedValue(const ValueReader& value) {
  const TomlNode& node = value.node();
  if (std::holds_alternative<TomlNode::Table>(node.value)) return labelled(value);
  StatedValue stated{{tomlText(node), labelOf(value), std::nullopt}, node};
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    stated.value.number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&node.value)) {
    stated.value.number = *real;
  }
  return stated;
}

}  // namespace

std::string labelOf(const ValueReader& value) {
  const auto& node = value.node().value;
  if (const auto* whole = std::get_if<std::int64_t>(&node)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&node)) return shortestText(*real);
  if (const bool* flag = std::get_if<bool>(&node)) return *flag ? "true" : "false";
  if (!std::holds_alternative<std::string>(node)) {
    value.mismatch(std::string("a number, a word, or ") + kExpectedLabelled);
  }
  std::string label = value.text(kLongestLabel);
  if (label.empty()) value.mismatch("a word");
  return label;
}

std::vector<StatedValue> statedValues(const ValueReader& values) {
  std::vector<ValueReader> elements;
  std::vector<TomlNode> nodes;
  const bool isRange = std::holds_alternative<TomlNode::Table>(values.node().value);
  if (isRange) {
    nodes = nodesOf(rangeFrom(values), values.node().location);
    for (const TomlNode& node : nodes) elements.emplace_back(node, values.name());
  } else {
    elements = values.list(kExpectedValues);
  }
  std::vector<StatedValue> stated;
  document::readEach(elements, [&](const ValueReader& element) {
    StatedValue one = statedValue(element);
    const bool isTwice = std::ranges::any_of(
        stated, [&](const StatedValue& other) { return other.value.label == one.value.label; });
    if (isTwice) {
      element.fail(values.name() + " has " + one.value.label + " twice" +
                   (isRange ? "; between whole numbers all are whole: lower count" : ""));
    }
    stated.push_back(std::move(one));
  });
  return stated;
}

}  // namespace rotatebook::scene
