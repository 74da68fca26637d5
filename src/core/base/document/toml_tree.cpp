#include "base/document/toml_tree.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/document/problems.h"
#include "base/document/syntax_problem.h"
#include "base/document/toml_parser.h"
#include "base/document/toml_text.h"
#include "base/text.h"

namespace rotatebook::document {
namespace {

using LocationOf = std::function<std::string(const toml::source_region&)>;

// The deepest value of a scene, a number in a bound in an array in a panel, is at depth 6.
constexpr int kDeepest = 8;

TomlNode nodeFrom(const toml::node& source, const LocationOf& locationOf, int depth);

TomlNode::Array arrayFrom(const toml::array& source, const LocationOf& locationOf, int depth) {
  TomlNode::Array elements;
  for (const toml::node& element : source) elements.push_back(nodeFrom(element, locationOf, depth));
  return elements;
}

// toml++ sorts tables by name; messages are to come in the order of the text.
TomlNode::Table tableFrom(const toml::table& source, const LocationOf& locationOf, int depth) {
  std::vector<std::pair<const toml::key*, const toml::node*>> sorted;
  for (auto&& [key, node] : source) sorted.emplace_back(&key, &node);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.first->source().begin < b.first->source().begin;
  });

  TomlNode::Table table;
  for (const auto& [key, node] : sorted) {
    const std::string location = locationOf(key->source());
    table.push_back({std::string(key->str()), location, nodeFrom(*node, locationOf, depth)});
  }
  return table;
}

TomlNode nodeFrom(const toml::node& source, const LocationOf& locationOf, int depth) {
  TomlNode node{TomlDate{}, locationOf(source.source())};
  if (depth > kDeepest) failAt(node.location, "nested deeper than any value of a scene");
  switch (source.type()) {
    case toml::node_type::boolean:
      node.value = source.as_boolean()->get();
      break;
    case toml::node_type::integer:
      node.value = source.as_integer()->get();
      break;
    case toml::node_type::floating_point:
      node.value = source.as_floating_point()->get();
      break;
    case toml::node_type::string:
      node.value = source.as_string()->get();
      break;
    case toml::node_type::array:
      node.value = arrayFrom(*source.as_array(), locationOf, depth + 1);
      break;
    case toml::node_type::table:
      node.value = tableFrom(*source.as_table(), locationOf, depth + 1);
      break;
    default:
      break;
  }
  return node;
}

std::string positionIn(const std::string& file, const toml::source_region& region) {
  return file + ":" + std::to_string(region.begin.line) + ":" + std::to_string(region.begin.column);
}

void refuseLong(std::string_view text, const std::string& location, std::size_t most) {
  if (text.size() <= most) return;
  failAt(location, "longer than " + std::to_string(most / 1024) + " KiB, the limit for " +
                       (most == kLongestWords ? "a list of words" : "a scene"));
}

std::string describeText(const std::string& text) {
  constexpr std::size_t kMaxShown = 200;
  const std::size_t characters = characterCount(text);
  return characters <= kMaxShown ? tomlString(text)
                                 : "a string of " + std::to_string(characters) + " characters";
}

std::string describeArray(const TomlNode::Array& array) {
  constexpr std::size_t kMaxShown = 4;
  if (array.size() > kMaxShown) return "an array of " + std::to_string(array.size()) + " values";
  std::vector<std::string> parts;
  for (const TomlNode& element : array) parts.push_back(describe(element));
  return "[" + joined(parts) + "]";
}

std::string keyText(const std::string& key) {
  constexpr std::string_view kBare =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return key.empty() || key.find_first_not_of(kBare) != key.npos ? tomlString(key) : key;
}

bool areTables(const TomlNode& node) {
  const auto* array = std::get_if<TomlNode::Array>(&node.value);
  return array != nullptr && !array->empty() &&
         std::ranges::all_of(*array, [](const TomlNode& element) {
           return std::holds_alternative<TomlNode::Table>(element.value);
         });
}

/// Returns a line for each value; those of tables within have dotted keys.
std::string linesOf(const TomlNode::Table& table, const std::string& prefix = "") {
  std::string lines;
  for (const TomlEntry& entry : table) {
    const std::string key = prefix + keyText(entry.key);
    const auto* inner = std::get_if<TomlNode::Table>(&entry.node.value);
    lines += inner != nullptr && !inner->empty() ? linesOf(*inner, key + ".")
                                                 : key + " = " + tomlText(entry.node) + "\n";
  }
  return lines;
}

}  // namespace

void failAt(const std::string& location, const std::string& problem) {
  throw DocumentError({{location, problem, {}, {}}});
}

TomlNode parseToml(std::string_view text, const std::string& file, std::size_t most) {
  refuseLong(text, file, most);
  const LocationOf locationOf = [&file](const auto& region) { return positionIn(file, region); };
  try {
    return nodeFrom(toml::parse(text, std::string_view(file)), locationOf, 0);
  } catch (const toml::parse_error& error) {
    const toml::source_position& place = error.source().begin;
    failAt(locationOf(error.source()),
           syntaxProblem(text, place.line, place.column, error.description()));
  }
}

std::optional<TomlNode> parseTomlValue(std::string_view text, const std::string& location) {
  refuseLong(text, location, kLongestToml);
  const LocationOf locationOf = [&location](const auto&) { return location; };
  try {
    const toml::table table = toml::parse("value = " + std::string(text));
    // A line break in `text` could add more keys.
    if (table.size() != 1) return std::nullopt;
    return nodeFrom(*table.get("value"), locationOf, 0);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

TomlEntry* find(TomlNode::Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &TomlEntry::key);
  return found == table.end() ? nullptr : &*found;
}

const TomlEntry* find(const TomlNode::Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &TomlEntry::key);
  return found == table.end() ? nullptr : &*found;
}

std::string tomlText(const TomlNode& node) {
  struct Printer {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return tomlNumber(value); }
    std::string operator()(const std::string& value) const { return tomlString(value); }
    std::string operator()(const TomlDate&) const { return ""; }
    std::string operator()(const TomlNode::Array& array) const {
      return "[" + joinedOf(array, tomlText) + "]";
    }
    std::string operator()(const TomlNode::Table& table) const {
      const auto entryText = [](const TomlEntry& entry) {
        return tomlString(entry.key) + " = " + tomlText(entry.node);
      };
      return "{ " + joinedOf(table, entryText) + " }";
    }
  };
  return std::visit(Printer{}, node.value);
}

std::string documentText(const TomlNode& root) {
  std::string text, sections;
  for (const TomlEntry& entry : std::get<TomlNode::Table>(root.value)) {
    const std::string key = keyText(entry.key);
    if (const auto* table = std::get_if<TomlNode::Table>(&entry.node.value)) {
      sections += "\n[" + key + "]\n" + linesOf(*table);
    } else if (areTables(entry.node)) {
      for (const TomlNode& element : std::get<TomlNode::Array>(entry.node.value))
        sections += "\n[[" + key + "]]\n" + linesOf(std::get<TomlNode::Table>(element.value));
    } else {
      text += key + " = " + tomlText(entry.node) + "\n";
    }
  }
  return text + sections;
}

std::string describe(const TomlNode& node) {
  struct Describer {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return tomlNumber(value); }
    std::string operator()(const std::string& value) const { return describeText(value); }
    std::string operator()(const TomlDate&) const { return "a date or time"; }
    std::string operator()(const TomlNode::Array& array) const { return describeArray(array); }
    std::string operator()(const TomlNode::Table&) const { return "a table"; }
  };
  return std::visit(Describer{}, node.value);
}

}  // namespace rotatebook::document
