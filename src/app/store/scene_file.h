// Scenes as files.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/scene.h"

namespace rotatebook::store {

/// Reads and validates a scene's file, as scene::parseScene(). Throws InputError, for a file that
/// isn't there with the nearest name that is.
scene::Scene readScene(const std::filesystem::path& path,
                       std::span<const std::string> overrides = {});

/// Reads the text of a scene's file, at most 32 KiB, and checks nothing else. Throws InputError.
std::string readSceneText(const std::filesystem::path& path);

}  // namespace rotatebook::store
