// --set: values from the command line in place of those of the scene file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/toml_tree.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMostOverrides = 1000;

/// Puts each "key.path=value" into `root`, a table, in their order. The value is TOML, or else a
/// bare string. An element of an array has its number from 0 for a key: panel.0.label.
/// Setting either of initial.angular_velocity and initial.angular_momentum takes the other one out.
/// Only the form is checked here. Throws InputError "--set KEY=VALUE: PROBLEM", and
/// for more than kMostOverrides.
void applyOverrides(TomlNode& root, std::span<const std::string> overrides);

}  // namespace rotatebook::scene
