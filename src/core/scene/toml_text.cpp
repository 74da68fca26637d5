#include "scene/toml_text.h"

#include <algorithm>
#include <optional>

#include "base/number_text.h"

namespace rotatebook::scene {
namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

std::string numbered(unsigned char code) {
  return std::string("\\u00") + kDigits[code >> 4] + kDigits[code & 15];
}

/// What stands for the letter or the piece of one that `text`, not empty, begins with, if TOML
/// wants an escape for it: its escape, and its size. [bytes]
struct Escape {
  std::string text;
  std::size_t size = 1;
};

/// Of a control character other than the tab and the line break.
std::optional<Escape> controlEscape(std::string_view text) {
  const auto code = static_cast<unsigned char>(text.front());
  if (code == '\n' || code == '\t') return std::nullopt;
  if (code < 0x20 || code == 0x7f) return Escape{numbered(code)};
  // Some terminals obey those of U+0080 to U+009F, too.
  if (code != 0xc2 || text.size() < 2) return std::nullopt;
  const auto second = static_cast<unsigned char>(text[1]);
  if (second < 0x80 || second > 0x9f) return std::nullopt;
  return Escape{numbered(second), 2};
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

/// Where the letters after the first `count` begin; what isn't UTF-8 may end between two bytes.
std::size_t endOfLetters(std::string_view text, std::size_t count) {
  constexpr std::size_t kLongestLetter = 4;
  const std::size_t most = std::min(text.size(), kLongestLetter * count);
  for (std::size_t i = 0; i < most; ++i) {
    if (beginsLetter(text[i]) && count-- == 0) return i;
  }
  return most;
}

}  // namespace

std::string tomlString(std::string_view text) {
  return '"' + escaped(text, stringEscape) + '"';
}

std::string printable(std::string_view text) {
  return escaped(text, controlEscape);
}

std::string oneLine(std::string_view text, std::size_t most) {
  const std::size_t end = endOfLetters(text, most);
  return escaped(text.substr(0, end), lineEscape) + (end < text.size() ? "..." : "");
}

std::size_t letterCount(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, beginsLetter));
}

std::string tomlNumber(double value) {
  const std::string text = shortestText(value);
  const bool looksWhole = text.find_first_not_of("-0123456789") == std::string::npos;
  return looksWhole ? text + ".0" : text;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

}  // namespace rotatebook::scene
