#include "cli/text_width.h"

#include <glib.h>

namespace rotatebook::cli {
namespace {

/// The first letter of a text.
struct Letter {
  std::size_t bytes = 1;
  std::size_t columns = 1;
};

Letter firstLetter(std::string_view text) {
  const auto size = static_cast<gssize>(text.size());
  const gunichar letter = g_utf8_get_char_validated(text.data(), size);
  // The values of an error: bytes that are no UTF-8 are shown one by one.
  if (letter >= static_cast<gunichar>(-2)) return {};
  const auto bytes = static_cast<std::size_t>(g_unichar_to_utf8(letter, nullptr));
  if (g_unichar_iszerowidth(letter)) return {bytes, 0};
  return {bytes, g_unichar_iswide(letter) ? std::size_t{2} : std::size_t{1}};
}

}  // namespace

std::size_t columnsOf(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const Letter letter = firstLetter(text);
    columns += letter.columns;
    text.remove_prefix(letter.bytes);
  }
  return columns;
}

std::string_view firstColumns(std::string_view text, std::size_t columns) {
  std::size_t taken = 0, bytes = 0;
  while (bytes < text.size()) {
    const Letter letter = firstLetter(text.substr(bytes));
    taken += letter.columns;
    if (taken > columns) break;
    bytes += letter.bytes;
  }
  return text.substr(0, bytes);
}

std::string cutTo(std::string_view text, std::size_t columns) {
  if (columnsOf(text) <= columns) return std::string(text);
  return columns == 0 ? "" : std::string(firstColumns(text, columns - 1)) + "…";
}

}  // namespace rotatebook::cli
