// Values as TOML writes them.
#pragma once

#include <string>
#include <string_view>

namespace rotatebook::scene {

/// A basic string: in quotes, with escapes where TOML wants them.
std::string tomlString(std::string_view text);

/// A TOML float that reads back to exactly `value`, also where it is whole: "2.0".
std::string tomlNumber(double value);

}  // namespace rotatebook::scene
