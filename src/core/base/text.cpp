#include "base/text.h"

#include <algorithm>
#include <optional>

namespace rotatebook {
namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

std::string unicodeEscape(unsigned char code) {
  return std::string("\\u00") + kDigits[code >> 4] + kDigits[code & 15];
}

/// An escape sequence, and the size of what it replaces at the beginning of a text. [bytes]
struct Escape {
  std::string text;
  std::size_t size = 1;
};

/// Escapes the control character that `text`, not empty, begins with; nullopt if it begins with
/// none, or with a tab or line break.
std::optional<Escape> controlEscape(std::string_view text) {
  const auto code = static_cast<unsigned char>(text.front());
  if (code == '\n' || code == '\t') return std::nullopt;
  if (code < 0x20 || code == 0x7f) return Escape{unicodeEscape(code)};
  // Some terminals obey the control characters U+0080 to U+009F, too.
  if (code != 0xc2 || text.size() < 2) return std::nullopt;
  const auto second = static_cast<unsigned char>(text[1]);
  if (second < 0x80 || second > 0x9f) return std::nullopt;
  return Escape{unicodeEscape(second), 2};
}

std::optional<Escape> lineEscape(std::string_view text) {
  switch (text.front()) {
    case '\n':
      return Escape{"\\n"};
    case '\t':
      return Escape{"\\t"};
    default:
      return controlEscape(text);
  }
}

std::optional<Escape> stringEscape(std::string_view text) {
  switch (text.front()) {
    case '"':
      return Escape{"\\\""};
    case '\\':
      return Escape{"\\\\"};
    default:
      return lineEscape(text);
  }
}

std::string escaped(std::string_view text, std::optional<Escape> (*escapeOf)(std::string_view)) {
  std::string result;
  while (!text.empty()) {
    const Escape next = escapeOf(text).value_or(Escape{std::string(text.substr(0, 1))});
    result += next.text;
    text.remove_prefix(next.size);
  }
  return result;
}

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

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kWhitespace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kWhitespace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kWhitespace) - first + 1);
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

std::string sizeText(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::string quotedText(std::string_view text) {
  return '"' + escaped(text, stringEscape) + '"';
}

std::string printable(std::string_view text) {
  return escaped(text, controlEscape);
}

std::string oneLine(std::string_view text, std::size_t maxLetters) {
  const std::string_view shown = firstCharacters(text, maxLetters);
  return escaped(shown, lineEscape) + (shown.size() < text.size() ? "..." : "");
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
    const bool control = static_cast<unsigned char>(text.front()) < ' ' || text.front() == 0x7f;
    if (size == 0 || control) return false;
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
