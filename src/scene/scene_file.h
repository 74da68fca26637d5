// Scenes as TOML, in and out.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace rotatebook::scene {

/// Reads and validates a scene. `overrides` are "key.path=value" as --set takes them; the value is
/// TOML, or else a bare string. Throws InputError: "FILE:LINE:COLUMN: what is wrong; the nearest
/// valid key or value". An override's place is
/// "--set KEY=VALUE".
Scene readScene(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// The same from text; `path` names it in messages and gives Scene::name and Scene::folder.
Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides = {});

/// The scene as TOML with every default explicit. Reading it back gives an equal scene.
std::string sceneText(const Scene& scene);

}  // namespace rotatebook::scene
