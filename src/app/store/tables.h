// Writing of the tables of a clip's motions.
#pragma once

#include <filesystem>
#include <vector>

#include "timeline/clip_motion.h"

namespace rotatebook::store {

/// Writes the table of each motion, see timeline::writeCsv(), to the file with the same index in
/// `files`. Throws MachineError.
void writeTables(const std::vector<std::filesystem::path>& files,
                 const timeline::ClipMotion& motion);

}  // namespace rotatebook::store
