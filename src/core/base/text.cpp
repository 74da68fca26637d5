#include "base/text.h"

#include <algorithm>
#include <optional>

namespace rotatebook {
namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

bool beginsLetter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
}

/// Returns the size of the letter (code point) that `text`, not empty, begins with; 0 if it isn't
/// UTF-8 (table 3-7 of the Unicode Standard). [bytes]
std::size_t letterSize(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  const std::size_t size = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  // Rejects overlong forms, surrogates, and code points above U+10FFFF.
  const unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  const unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < size; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  return size;
}

/// Returns the code point of `letter`, one whole letter.
char32_t codePoint(std::string_view letter) {
  constexpr unsigned kLeadBits[] = {0x7f, 0x7f, 0x1f, 0x0f, 0x07};
  char32_t code = static_cast<unsigned char>(letter.front()) & kLeadBits[letter.size()];
  for (const char byte : letter.substr(1)) code = code << 6 | (static_cast<unsigned>(byte) & 0x3f);
  return code;
}

/// Returns whether a terminal may obey the code point, break the line at it, or turn the direction
/// of writing: control characters (C0, DEL, C1), separators of lines, and bidirectional marks.
bool isControl(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x61c || code == 0x200e ||
         code == 0x200f || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

std::string unicodeEscape(char32_t code) {
  std::string escape = "\\u";
  for (const int shift : {12, 8, 4, 0}) escape += kDigits[code >> shift & 15];
  return escape;
}

/// Returns what to write in place of the beginning of a text, or nullopt to keep its first letter.
using Escape = std::optional<std::string> (*)(std::string_view);

std::optional<std::string> controlEscape(std::string_view text) {
  if (text.front() == '\n' || text.front() == '\t') return std::nullopt;
  const std::size_t size = letterSize(text);
  if (size == 0) return "\uFFFD";  // a byte that isn't UTF-8
  const char32_t code = codePoint(text.substr(0, size));
  return isControl(code) ? std::optional(unicodeEscape(code)) : std::nullopt;
}

std::optional<std::string> lineEscape(std::string_view text) {
  switch (text.front()) {
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      return controlEscape(text);
  }
}

std::optional<std::string> stringEscape(std::string_view text) {
  switch (text.front()) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    default:
      return letterSize(text) == 0 ? std::nullopt : lineEscape(text);
  }
}

std::optional<std::string> messageEscape(std::string_view text) {
  return text.starts_with(kNextLine) ? std::nullopt : lineEscape(text);
}

std::string escaped(std::string_view text, Escape escapeOf) {
  std::string result;
  while (!text.empty()) {
    const std::string_view letter = text.substr(0, std::max<std::size_t>(letterSize(text), 1));
    result += escapeOf(text).value_or(std::string(letter));
    text.remove_prefix(letter.size());
  }
  return result;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kWhitespace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kWhitespace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kWhitespace) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

std::vector<std::string> itemsOf(std::string_view text, char at) {
  std::vector<std::string> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    items.emplace_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return items;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty() && !part.empty()) text += between;
    text += part;
  }
  return text;
}

std::string listed(const std::vector<std::string>& parts, std::string_view lastWord) {
  if (parts.empty()) return "nothing";
  std::string text = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    text += (last ? " " + std::string(lastWord) + " " : ", ") + parts[i];
  }
  return text;
}

std::string filledIn(std::string_view text, const std::vector<NamedText>& values) {
  std::string filled;
  while (!text.empty()) {
    const auto begins = [&](const NamedText& one) {
      return text.starts_with("{" + std::string(one.first) + "}");
    };
    const auto value = std::ranges::find_if(values, begins);
    const bool isText = value == values.end();
    filled += isText ? std::string(text.substr(0, 1)) : value->second;
    text.remove_prefix(isText ? 1 : value->first.size() + 2);
  }
  return filled;
}

std::string countText(std::int64_t count, std::string_view one) {
  return countText(std::to_string(count), one);
}

std::string countText(std::string_view number, std::string_view one) {
  return std::string(number) + ' ' + std::string(one) + (number == "1" ? "" : "s");
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

std::string sizeText(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::string quotedText(std::string_view text) {
  return '"' + escaped(text, stringEscape) + '"';
}

std::string quotedBeginning(std::string_view text, std::size_t maxLetters) {
  const std::string_view shown = firstCharacters(text, maxLetters);
  return quotedText(validUtf8(shown) + (shown.size() < text.size() ? "..." : ""));
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"") == text.npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string shellWord(std::string text) {
  const bool isPlain = text.find_first_of(" \t\n'\"\\`$&|;<>()*?[]{}~#!") == std::string::npos;
  if (isPlain && !text.empty()) return text;
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 4) {
    text.replace(at, 1, R"('\'')");
  }
  return '\'' + text + '\'';
}

std::string printable(std::string_view text) {
  return escaped(text, controlEscape);
}

std::string oneLine(std::string_view text, std::size_t maxLetters) {
  const std::string_view shown = firstCharacters(text, maxLetters);
  return escaped(shown, lineEscape) + (shown.size() < text.size() ? "..." : "");
}

std::string messageText(std::string_view text) {
  return escaped(text, messageEscape);
}

std::string validUtf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t size = letterSize(text);
    valid += size > 0 ? text.substr(0, size) : "\uFFFD";
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return valid;
}

bool isOneLine(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = letterSize(text);
    if (size == 0 || isControl(codePoint(text.substr(0, size)))) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::size_t characterCount(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, beginsLetter));
}

std::string_view firstCharacters(std::string_view text, std::size_t count) {
  constexpr std::size_t kMaxLetterSize = 4;  // [bytes]
  const std::size_t end = std::min(text.size(), kMaxLetterSize * count);
  for (std::size_t i = 0; i < end; ++i) {
    if (beginsLetter(text[i]) && count-- == 0) return text.substr(0, i);
  }
  return text.substr(0, end);
}

}  // namespace rotatebook
