// Writing of the tables of a clip's motions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::store {

/// Writes each of timeline::writeTable() to the file with the same index in `files`. Throws
/// MachineError.
void writeTables(const std::vector<std::filesystem::path>& files, const scene::Scene& scene,
                 const timeline::ClipMotion& motion);

/// Throws InputError if one of `files`, which all lie in `folder`, belongs to a clip there other
/// than `clip`. The message ends with `remedy`, which also says what would replace it.
void refuseLostTables(const std::filesystem::path& folder, const std::string& clip,
                      const std::vector<std::filesystem::path>& files, const std::string& remedy);

}  // namespace rotatebook::store
