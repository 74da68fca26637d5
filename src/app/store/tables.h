// The tables of a clip's motions on the disk.
#pragma once

#include <filesystem>
#include <vector>

#include "timeline/clip_motion.h"

namespace rotatebook::store {

/// Writes the table of each motion, timeline::trajectoryCsv(), to the file of the same place in
/// `files`. Throws MachineError.
void writeTables(const std::vector<std::filesystem::path>& files,
                 const timeline::ClipMotion& motion);

}  // namespace rotatebook::store
