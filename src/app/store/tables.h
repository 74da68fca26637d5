// Writing of the tables and the result of a clip's motions.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"
#include "timeline/motion_summary.h"

namespace rotatebook::store {

/// Writes each of timeline::writeTable() to the file with the same index in `files`. Throws
/// MachineError.
void writeTables(const std::vector<std::filesystem::path>& files, const scene::Scene& scene,
                 const timeline::ClipMotion& motion);

/// Writes timeline::clipJson() to `file`; `motionSum` is the motion's checksum. Throws
/// MachineError.
void writeResult(const std::filesystem::path& file, const scene::Scene& scene,
                 const timeline::ClipMotion& motion,
                 const std::vector<timeline::MotionSummary>& summaries, std::string_view motionSum);

}  // namespace rotatebook::store
