// Prints values as TOML.
#pragma once

#include <string>
#include <string_view>

namespace rotatebook::scene {

/// Returns a basic string: in quotes, with escapes where TOML requires them.
std::string tomlString(std::string_view text);

/// Returns a TOML float that reads back to exactly `value`, even if it is whole: "2.0".
std::string tomlNumber(double value);

}  // namespace rotatebook::scene
