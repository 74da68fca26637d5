// Text as a number, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace rotatebook {

/// Returns the number that all of `text` is, without blanks or a plus sign; nothing if it is none,
/// or none that `Number` has.
template <typename Number>
std::optional<Number> parsedNumber(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace rotatebook
