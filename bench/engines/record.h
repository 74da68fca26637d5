// Recordings of engines' own motions, as tables that rotatebook reads.
#pragma once

#include <filesystem>
#include <vector>

#include "engines/engine.h"

namespace rotatebook::bench {

/// Writes FOLDER/NAME.csv for each motion that is to be recorded of the engines that are installed:
/// times, attitudes and angular velocities in world axes, 60 or 50 a second. The book's mass is the
/// recording's. Throws MachineError if a file can't be written.
void recordEngines(const Motion& motion, const std::vector<Family>& families,
                   const std::filesystem::path& folder);

}  // namespace rotatebook::bench
