#include "base/document/overrides.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/document/problems.h"
#include "base/document/toml_text.h"
#include "base/error.h"
#include "base/parsed_number.h"
#include "base/text.h"

namespace rotatebook::document {
namespace {

using Path = std::vector<std::string_view>;

Path pathFrom(std::string_view key, const std::string& location) {
  Path path;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    path.push_back(key.substr(begin, end - begin));
    if (path.back().empty()) failAt(location, "the key, or a part of it, is empty");
    begin = end + 1;
  }
  constexpr std::size_t kLongestPath = 6;  // panel.0.expect.QUANTITY.1.BOUND
  if (path.size() > kLongestPath) failAt(location, "no key of a scene has more than six parts");
  return path;
}

// Returns the element of `array` whose number from 0 is `key`.
TomlNode& elementOf(TomlNode::Array& array, std::string_view key, std::string_view name,
                    const std::string& location) {
  const auto index = parsedNumber<std::size_t>(key);
  if (index && *index < array.size()) return array[*index];
  failAt(location, std::string(name) + " has " + countText(std::ssize(array), "element") +
                       ", numbered from 0, and no " + tomlString(key));
}

// Returns the value of `key` in `node`; adds an empty table if there is none. Messages call `node`
// by `name`.
TomlNode& childOf(TomlNode& node, std::string_view key, std::string_view name,
                  const std::string& location) {
  if (auto* array = std::get_if<TomlNode::Array>(&node.value)) {
    return elementOf(*array, key, name, location);
  }
  // A flag may be the short form of a table, as normalize = true is of { every = 1 }.
  if (std::holds_alternative<bool>(node.value)) node.value = TomlNode::Table{};
  auto* table = std::get_if<TomlNode::Table>(&node.value);
  if (!table) failAt(location, std::string(name) + " is " + describe(node) + ", which has no keys");
  if (TomlEntry* entry = find(*table, key)) return entry->node;
  table->push_back({std::string(key), location, {TomlNode::Table{}, location}});
  return table->back().node;
}

TomlNode valueFrom(std::string_view text, const std::string& location) {
  if (auto value = parseTomlValue(text, location)) return *std::move(value);
  if (auto bareString = parseTomlValue(tomlString(text), location)) return *std::move(bareString);
  failAt(location, "the value isn't UTF-8");
}

bool isAmong(std::span<const std::string_view> keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void applyOverride(TomlNode& root, const std::string& text,
                   std::span<const Alternatives> alternatives) {
  const std::string location = overrideLocation(text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) failAt(location, "expected KEY=VALUE");
  const std::string_view key = trimmed(std::string_view(text).substr(0, equals));
  const std::string_view value = trimmed(std::string_view(text).substr(equals + 1));
  putValue(root, key, valueFrom(value, location), location, alternatives);
}

}  // namespace

bool areAlternatives(std::span<const Alternatives> all, std::string_view section,
                     std::string_view one, std::string_view other) {
  return one != other && std::ranges::any_of(all, [&](const Alternatives& keys) {
           return keys.section == section && isAmong(keys.keys, one) && isAmong(keys.keys, other);
         });
}

void putValue(TomlNode& root, std::string_view key, TomlNode value, const std::string& location,
              std::span<const Alternatives> alternatives) {
  const Path path = pathFrom(key, location);

  TomlNode* parent = &root;
  TomlNode* node = &root;
  for (const std::string_view part : path) {
    // `part` lies within `key`; the text before it, without its last dot, is the path of `node`.
    const auto before = static_cast<std::size_t>(part.data() - key.data());
    parent = node;
    node = &childOf(*parent, part, key.substr(0, before - (before > 0 ? 1 : 0)), location);
  }
  *node = std::move(value);
  auto* section = std::get_if<TomlNode::Table>(&parent->value);
  if (path.size() < 2 || section == nullptr) return;
  std::erase_if(*section, [&](const TomlEntry& entry) {
    return areAlternatives(alternatives, path[path.size() - 2], entry.key, path.back());
  });
}

std::string overrideLocation(std::string_view text) {
  constexpr std::size_t kMaxShown = 200;
  return "--set " + oneLine(text, kMaxShown);
}

void applyOverrides(TomlNode& root, std::span<const std::string> overrides,
                    std::span<const Alternatives> alternatives) {
  if (overrides.size() > kMaxOverrides) {
    throw InputError("--set: " + std::to_string(overrides.size()) + " options; the limit is " +
                     std::to_string(kMaxOverrides) + "; write the values into the scene's file");
  }
  Problems problems;
  for (const std::string& text : overrides) {
    problems.note([&] { applyOverride(root, text, alternatives); });
  }
  problems.throwIfAny();
}

}  // namespace rotatebook::document
