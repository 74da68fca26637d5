// Words for people: put together, counted, kept on a line. Text is UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook {

/// `text` without blanks, tabs and ends of lines at its beginning and end.
std::string_view trimmed(std::string_view text);

/// "a, b, c" of the parts that aren't empty.
std::string joined(const std::vector<std::string>& parts, std::string_view between = ", ");

/// The same of `items`, each of which `textOf` makes a string of.
template <typename Items, typename TextOf>
std::string joinedOf(const Items& items, const TextOf& textOf) {
  std::vector<std::string> parts;
  for (const auto& item : items) parts.push_back(textOf(item));
  return joined(parts);
}

/// "a, b and c", with the given word before the last; "nothing" of no parts.
std::string listed(const std::vector<std::string>& parts, std::string_view lastWord = "and");

/// "640x360"
std::string sizeText(std::int64_t width, std::int64_t height);

/// In quotation marks, with escapes for these, backslashes and control characters; both TOML and
/// JSON read it back.
std::string quotedText(std::string_view text);

/// `text` with an escape for each control character but tab and line break, so that a terminal
/// doesn't obey it.
std::string printable(std::string_view text);

/// `text` on one line: as printable(), but tabs and line breaks, too; the first `most` letters and
/// "..." if it has more.
std::string oneLine(std::string_view text, std::size_t most);

/// Whether it is UTF-8 (RFC 3629) without control characters of ASCII.
bool isOneLine(std::string_view text);

/// How many letters (code points) it has.
std::size_t letterCount(std::string_view text);

/// Its first `count` letters, all if it has fewer. What isn't UTF-8 may end between two bytes: a
/// letter has at most four.
std::string_view firstLetters(std::string_view text, std::size_t count);

}  // namespace rotatebook
