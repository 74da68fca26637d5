#include "base/document/value_reader.h"

#include <algorithm>
#include <variant>

#include "base/document/problems.h"
#include "base/document/toml_text.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "base/units.h"

namespace rotatebook::document {
namespace {

std::optional<double> numberFrom(const TomlNode& node) {
  if (const auto* real = std::get_if<double>(&node.value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&node.value))
    return static_cast<double>(*whole);
  return std::nullopt;
}

}  // namespace

std::string expectedInteger(int min, int max) {
  return "an integer from " + std::to_string(min) + " to " + std::to_string(max);
}

std::string expectedString(std::size_t most) {
  return "a string of at most " + std::to_string(most) + " characters";
}

std::string ValueReader::text(std::size_t most) const {
  const std::string text = lines(most);
  if (!isOneLine(text)) mismatch("a string on one line, without control characters");
  return text;
}

std::string ValueReader::lines(std::size_t most) const {
  const auto* text = std::get_if<std::string>(&node_->value);
  if (!text) mismatch("a string in quotes");
  if (characterCount(*text) > most) mismatch(expectedString(most));
  if (printable(*text) != *text) mismatch("a string without control characters");
  return *text;
}

int ValueReader::integer(int min, int max) const {
  const auto* whole = std::get_if<std::int64_t>(&node_->value);
  if (!whole || *whole < min || *whole > max) mismatch(expectedInteger(min, max));
  return static_cast<int>(*whole);
}

double ValueReader::number(const NumberRange& range) const {
  const auto* text = std::get_if<std::string>(&node_->value);
  const bool isQuantity = text != nullptr && range.dimension;
  const std::optional<double> number =
      isQuantity ? parseQuantity(*text, *range.dimension) : numberFrom(*node_);
  if (isQuantity && !number) {
    const std::vector<std::string_view> units = unitsOf(*range.dimension);
    fail(name_ + " must be " + std::string(range.expected) + ", not " + describe(*node_) +
         "; a text is a number and a unit, " + quotedList(units, "or") + ", such as \"1.5 " +
         std::string(units[0]) + "\"" +
         (isUnit(unitIn(*text)) ? "" : didYouMean(unitIn(*text), units)));
  }
  // NaN compares false with everything.
  if (!number || !(*number >= range.min && *number <= range.max))
    mismatch(std::string(range.expected));
  return *number;
}

std::size_t ValueReader::choice(std::span<const std::string_view> names) const {
  const std::string expected = quotedList(names, "or");
  const auto* text = std::get_if<std::string>(&node_->value);
  if (!text) mismatch(expected);
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  fail(name_ + " must be " + expected + ", not " + describe(*node_) + didYouMean(*text, names));
}

std::vector<ValueReader> ValueReader::elements(std::size_t count,
                                               const std::string& expected) const {
  const auto* array = std::get_if<TomlNode::Array>(&node_->value);
  if (!array || array->size() != count) mismatch(expected);
  std::vector<ValueReader> elements;
  for (const TomlNode& element : *array) elements.emplace_back(element, name_);
  return elements;
}

std::vector<ValueReader> ValueReader::list(const std::string& expected) const {
  const auto* array = std::get_if<TomlNode::Array>(&node_->value);
  if (!array || array->empty()) mismatch(expected);
  return elements(array->size(), expected);
}

std::vector<ValueReader> ValueReader::tables(const std::string& expected) const {
  std::vector<ValueReader> tables{*this};
  if (std::holds_alternative<TomlNode::Array>(node_->value)) tables = list(expected);
  for (const ValueReader& table : tables) {
    if (!std::holds_alternative<TomlNode::Table>(table.node_->value)) table.mismatch(expected);
  }
  return tables;
}

void ValueReader::readTable(const std::vector<Field>& fields) const {
  const auto* table = std::get_if<TomlNode::Table>(&node_->value);
  if (!table) mismatch("a section");
  Problems problems;
  for (const TomlEntry& entry : *table) {
    problems.note([&] {
      const auto field = std::ranges::find(fields, entry.key, &Field::key);
      if (field == fields.end()) refuseKey(entry, fields);
      field->read(ValueReader(entry.node, nameOfKey(entry.key)));
    });
  }
  problems.throwIfAny();
}

void readEach(std::span<const ValueReader> values,
              const std::function<void(const ValueReader&)>& read) {
  Problems problems;
  for (const ValueReader& value : values) problems.note([&] { read(value); });
  problems.throwIfAny();
}

std::optional<ValueReader> ValueReader::find(std::string_view key) const {
  const auto* table = std::get_if<TomlNode::Table>(&node_->value);
  const TomlEntry* entry = table ? document::find(*table, key) : nullptr;
  if (!entry) return std::nullopt;
  return ValueReader(entry->node, nameOfKey(key));
}

std::optional<ValueReader> ValueReader::find(std::string_view section, std::string_view key) const {
  const auto found = find(section);
  return found ? found->find(key) : std::nullopt;
}

void ValueReader::mismatch(const std::string& expected) const {
  fail(name_ + " must be " + expected + ", not " + describe(*node_));
}

void ValueReader::fail(const std::string& problem) const {
  failAt(node_->location, problem);
}

std::string ValueReader::nameOfKey(std::string_view key) const {
  return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
}

void ValueReader::refuseKey(const TomlEntry& entry, const std::vector<Field>& fields) const {
  std::vector<std::string_view> valid;
  valid.reserve(fields.size());
  for (const Field& field : fields) valid.push_back(field.key);
  const bool isSection = name_.empty() && std::holds_alternative<TomlNode::Table>(entry.node.value);
  const std::string where = name_.empty() ? "" : " in [" + name_ + "]";
  std::string remedy = didYouMean(entry.key, valid);
  if (remedy.empty()) {
    remedy = (valid.size() == 1 ? "; valid is " : "; valid are ") + quotedList(valid, "and");
  }
  throw DocumentError(
      {{entry.keyLocation,
        (isSection ? "unknown section " : "unknown key ") + tomlString(entry.key) + where, remedy,
        isSection ? "" : entry.key}});
}

}  // namespace rotatebook::document
