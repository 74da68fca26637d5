// Scenes as TOML, in and out.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "physics/layout.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Reads and validates the text of a scene; `path` names it in messages and gives Scene::name and
/// Scene::folder, and isn't opened. Throws InputError "FILE:LINE:COLUMN: what is wrong" about the
/// first problem, with the nearest valid key or value.
///
/// `overrides` are "key.path=value" as --set takes them: the value is TOML, or else a bare string.
/// They count as part of the file; the place in a message is "--set KEY=VALUE". Setting one of
/// initial.angular_velocity and initial.angular_momentum takes the other one out.
/// `caller` is as physics::simulate() has it.
Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides = {},
                 const physics::Layout& caller = physics::layoutHere());

/// The scene as TOML with every default explicit. Reading it back gives an equal scene.
std::string sceneText(const Scene& scene);

}  // namespace rotatebook::scene
