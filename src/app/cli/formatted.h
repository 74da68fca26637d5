// Numbers in columns. Inside the room only.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace rotatebook::cli {

/// Returns at most 199 bytes of what std::printf() would print.
template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace rotatebook::cli
