// A number that tells builds of the program apart.
#pragma once

#include <string>

namespace rotatebook::system {

/// Returns a hexadecimal number that is another one for each build of the running program: the
/// linker's build id, in the memory of the program itself. So it is the same whoever loads the
/// program (/proc/self/exe may be the loader), and after a change to the file that leaves the code
/// as it is, such as another path of libraries. Without a build id it is the checksum of
/// /proc/self/exe; throws MachineError if that can't be read.
const std::string& buildId();

}  // namespace rotatebook::system
