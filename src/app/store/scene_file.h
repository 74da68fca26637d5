// Reading of scene files.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/scene.h"

namespace rotatebook::store {

/// Reads and validates a scene file, or that of system::kStandardInput in the working folder; see
/// scene::parseScene(). Throws InputError, also for a name that problemOfName() refuses; for a
/// missing file, the message suggests the nearest existing name. The file that overlay.words may
/// name is within the scene's folder, unless `allowOutside`, which the scene gets, too.
scene::Scene readScene(const std::filesystem::path& path,
                       std::span<const std::string> overrides = {}, bool allowOutside = false);

/// Returns the same of the file's text, which was read.
scene::Scene readScene(const std::filesystem::path& path, const std::string& text,
                       std::span<const std::string> overrides, bool allowOutside);

/// Throws InputError unless there is a file at `path` that a scene may be read from; for a missing
/// one, the message suggests the nearest existing name.
void requireScene(const std::filesystem::path& path);

/// Reads the files that the motions of a record's scene follow from, in the scene's folder, which
/// they don't leave unless Scene::allowOutside; see scene::readMotionFiles().
void readMotionFiles(scene::Scene& scene);

/// Reads the text of a scene file, or system::kStandardInput, without parsing it. Throws InputError
/// if it can't be read or is longer than document::kLongestToml.
std::string readSceneText(const std::filesystem::path& path);

}  // namespace rotatebook::store
