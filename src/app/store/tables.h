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

/// Throws InputError if one of `files`, the tables of a scene that are named after `csv`, belongs
/// to another clip in its folder.
void refuseLostTables(const std::filesystem::path& csv,
                      const std::vector<std::filesystem::path>& files);

}  // namespace rotatebook::store
