// Motions for the tests of an engine: starts, exact states and bounds, as files. Inside the room
// only.
#pragma once

#include <filesystem>

namespace rotatebook::cli {

/// Writes pack.json and a table for each motion, NAME.csv, into `folder`, which is made if there is
/// none. Throws InputError, before it writes anything, if a file that isn't a pack's is in the way.
void writePack(const std::filesystem::path& folder);

}  // namespace rotatebook::cli
