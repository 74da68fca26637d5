// A TOML document as a tree of plain values, each with its location.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rotatebook::document {

struct TomlEntry;

/// A date or a time. No key of a scene takes one, so its value isn't kept.
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
  std::string keyLocation;  ///< Like TomlNode::location.
  TomlNode node;
};

/// Longest text that is parsed: ten times what any scene needs. [bytes]
inline constexpr std::size_t kLongestToml = 32'768;
/// Likewise of a list of words.
inline constexpr std::size_t kLongestWords = 8 * kLongestToml;

/// Throws InputError "LOCATION: PROBLEM".
[[noreturn]] void failAt(const std::string& location, const std::string& problem);

/// Returns the tree of a whole text; its root is a table. Throws InputError with the position and a
/// remedy for what isn't TOML; also for what is longer than `most` or nested too deeply.
TomlNode parseToml(std::string_view text, const std::string& file, std::size_t most = kLongestToml);

/// Returns the single value in `text`, or nothing if it isn't one; every part of it has `location`.
/// Throws InputError if it is longer than kLongestToml or nested too deeply.
std::optional<TomlNode> parseTomlValue(std::string_view text, const std::string& location);

/// Returns the entry with that key, or null.
TomlEntry* find(TomlNode::Table& table, std::string_view key);
const TomlEntry* find(const TomlNode::Table& table, std::string_view key);

/// Returns a value as TOML on one line, with tables inline; it reads back to the same value. Dates
/// have no text.
std::string tomlText(const TomlNode& node);

/// Returns a whole document as TOML, a section for each table and each table of an array, after all
/// else; it reads back to the same values. `root` must be a table.
std::string documentText(const TomlNode& root);

/// Returns the description of a value for a message: as TOML writes it if that is short, else in
/// words.
std::string describe(const TomlNode& node);

}  // namespace rotatebook::document
