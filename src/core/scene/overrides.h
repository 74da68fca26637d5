// --set: values from the command line that replace those of the scene file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "scene/toml_tree.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMaxOverrides = 1000;

/// Applies each "key.path=value" to `root`, a table, in order. The value is TOML, or else a bare
/// string. The key of an array's element is its number from 0: panel.0.label. Setting either of
/// initial.angular_velocity and initial.angular_momentum removes the other. Only the form is
/// checked here. Goes on after one that is wrong, and throws SceneError in the end, with
/// overrideLocation(); InputError for more than kMaxOverrides.
void applyOverrides(TomlNode& root, std::span<const std::string> overrides);

/// Returns the location of an override for messages: "--set KEY=VALUE", printable and not too long.
std::string overrideLocation(std::string_view text);

}  // namespace rotatebook::scene
