// Values as TOML writes them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::scene {

/// A basic string: in quotes, with escapes where TOML wants them.
std::string tomlString(std::string_view text);

/// `text` with each control character but tab and line break as TOML escapes it, so that a terminal
/// doesn't obey it.
std::string printable(std::string_view text);

/// `text` on one line: as printable(), but tabs and line breaks, too; the first `most` letters and
/// "..." if it has more.
std::string oneLine(std::string_view text, std::size_t most);

/// Letters of UTF-8.
std::size_t letterCount(std::string_view text);

/// A TOML float that reads back to exactly `value`, also where it is whole: "2.0".
std::string tomlNumber(double value);

/// What stands between the brackets of an array or the braces of a table.
std::string joined(const std::vector<std::string>& parts);

}  // namespace rotatebook::scene
