// --set: values from the command line in place of those of the scene file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "scene/toml_tree.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMaxOverrides = 1000;

/// Puts each "key.path=value" into `root`, a table, in their order. The value is TOML, or else a
/// bare string. An element of an array has its number from 0 for a key: panel.0.label.
/// Setting either of initial.angular_velocity and initial.angular_momentum takes the other one out.
/// Only the form is checked here. Throws InputError "PLACE: PROBLEM", with
/// overrideLocation(), and for more than kMaxOverrides.
void applyOverrides(TomlNode& root, std::span<const std::string> overrides);

/// What messages call the location of an override: "--set KEY=VALUE", printable and not too long.
std::string overrideLocation(std::string_view text);

}  // namespace rotatebook::scene
