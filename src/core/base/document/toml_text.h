// Prints values as TOML.
#pragma once

#include <string>
#include <string_view>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::document {

/// Returns a basic string: in quotes, with escapes where TOML requires them.
inline std::string tomlString(std::string_view text) {
  return quotedText(text);
}

/// Returns a TOML float that reads back to exactly `value`, even if it is whole: "2.0".
inline std::string tomlNumber(double value) {
  const std::string text = shortestText(value);
  const bool looksWhole = text.find_first_not_of("-0123456789") == std::string::npos;
  return looksWhole ? text + ".0" : text;
}

}  // namespace rotatebook::document
