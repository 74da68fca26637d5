// Writing of the tables and the result of a clip's motions.
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

/// Writes timeline::clipJson() to `file`, unless that is empty. Throws MachineError.
void writeResult(const std::filesystem::path& file, const scene::Scene& scene,
                 const timeline::ClipMotion& motion);

}  // namespace rotatebook::store
