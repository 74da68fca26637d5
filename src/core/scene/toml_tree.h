// A TOML text as a tree of plain values, each of which knows where it stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rotatebook::scene {

struct TomlEntry;

/// A date or a time. No key of a scene takes one, so that its value is of no interest.
struct TomlDate {};

/// A value and its location.
struct TomlNode {
  using Array = std::vector<TomlNode>;
  using Table = std::vector<TomlEntry>;  ///< In the order of the text.

  std::variant<bool, std::int64_t, double, std::string, TomlDate, Array, Table> value;
  std::string location;  ///< "FILE:LINE:COLUMN", or "--set KEY=VALUE".
};

/// A key with its value.
struct TomlEntry {
  std::string key;
  std::string keyLocation;  ///< As TomlNode::location.
  TomlNode node;
};

/// Longest text that is parsed: ten times what any scene needs. It bounds how deep dotted keys can
/// nest, and with that the stack that parsing takes, under 2 MB. [bytes]
inline constexpr std::size_t kLongestToml = 32'768;

/// Throws InputError "PLACE: PROBLEM".
[[noreturn]] void failAt(const std::string& location, const std::string& problem);

/// The tree of a whole text; its root is a table. Throws InputError with the parser's words.
TomlNode parseToml(std::string_view text, const std::string& file);

/// A single value, or nothing if `text` isn't one; `location` is the location of every part of it.
std::optional<TomlNode> parseTomlValue(std::string_view text, const std::string& location);

/// The entry of that key, or null.
TomlEntry* find(TomlNode::Table& table, std::string_view key);
const TomlEntry* find(const TomlNode::Table& table, std::string_view key);

/// What a value is, for a message: as TOML writes it where that is short, else in words.
std::string describe(const TomlNode& node);

}  // namespace rotatebook::scene
