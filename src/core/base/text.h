// Functions that join, escape, count and shorten text for people. Text is UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rotatebook {

inline constexpr std::size_t kWholeText = 1 << 28;  ///< More letters than any text has.

/// Returns `text` without spaces, tabs and line ends at its beginning and end.
std::string_view trimmed(std::string_view text);

/// Returns `text` with small letters in place of A to Z.
std::string lowerCase(std::string_view text);

/// Returns the parts of `text` between letters `at`, one more than there are letters, trimmed.
std::vector<std::string> itemsOf(std::string_view text, char at = ',');

/// Returns "a, b, c" from the parts that aren't empty.
std::string joined(const std::vector<std::string>& parts, std::string_view between = ", ");

/// Like joined(), from the strings that `textOf` makes of `items`.
template <typename Items, typename TextOf>
std::string joinedOf(const Items& items, const TextOf& textOf) {
  std::vector<std::string> parts;
  for (const auto& item : items) parts.push_back(textOf(item));
  return joined(parts);
}

/// Returns "a, b and c", with `lastWord` before the last part; "nothing" if there are no parts.
std::string listed(const std::vector<std::string>& parts, std::string_view lastWord = "and");

/// Returns `text` without the byte order mark that it may begin with.
std::string_view withoutByteOrderMark(std::string_view text);

/// A name and its value.
using NamedText = std::pair<std::string_view, std::string>;

/// Returns `text` with each value in the place of its "{name}".
std::string filledIn(std::string_view text, const std::vector<NamedText>& values);

/// Returns "1 frame" or "2 frames", for `one` "frame".
std::string countText(std::int64_t count, std::string_view one);

/// Returns the same of a number's text: "1 degree" or "0.5 degrees".
std::string countText(std::string_view number, std::string_view one);

/// Returns a size as "640x360".
std::string sizeText(std::int64_t width, std::int64_t height);

/// Returns `text` in quotation marks, with escapes for quotation marks, backslashes, and whatever
/// isOneLine() refuses in UTF-8; both TOML and JSON read it back.
std::string quotedText(std::string_view text);

/// Returns likewise the first `maxLetters` letters, with "..." for the rest. Bytes that aren't
/// UTF-8 become U+FFFD.
std::string quotedBeginning(std::string_view text, std::size_t maxLetters);

/// Returns `text` as a word of a shell's command line: in quotation marks if it needs them.
std::string shellWord(std::string text);

/// Returns `text` as a field of a CSV, in quotation marks if it needs them. (RFC 4180)
std::string csvField(const std::string& text);

/// Returns `text` with an escape for whatever isOneLine() refuses, but for tabs and line breaks, so
/// that a terminal doesn't obey it. Bytes that aren't UTF-8 become U+FFFD.
std::string printable(std::string_view text);

/// Returns `text` on one line: like printable(), but with escapes for tabs and line breaks, too;
/// cut after `maxLetters` letters, with "..." for the rest.
std::string oneLine(std::string_view text, std::size_t maxLetters = kWholeText);

/// Begins each further line of an error's message.
inline constexpr std::string_view kNextLine = "\n  ";

/// Returns the text of an error's message: on one line, but for the lines that kNextLine begins.
std::string messageText(std::string_view text);

/// Returns `text` with U+FFFD in place of each byte that isn't part of UTF-8 (RFC 3629).
std::string validUtf8(std::string_view text);

/// Returns whether `text` is a line of UTF-8 (RFC 3629) that is safe to print: without control
/// characters (C0, DEL, C1), U+2028, U+2029 and bidirectional marks (U+061C, U+200E, U+200F, U+202A
/// to U+202E, U+2066 to U+2069).
bool isOneLine(std::string_view text);

/// Returns the number of letters (code points) in `text`.
std::size_t characterCount(std::string_view text);

/// Returns the first `count` letters, or all if there are fewer. Text that isn't UTF-8 may be cut
/// between any two bytes: no letter counts as more than four.
std::string_view firstCharacters(std::string_view text, std::size_t count);

}  // namespace rotatebook
