// What a command left, in words. Inside the room only.
#pragma once

#include <filesystem>
#include <string>

#include "store/disk_space.h"

namespace rotatebook::cli {

/// "about 12 GB are needed in out and 3.2 GB are free: ..."; empty if there is enough. `pngs`: they
/// are written, and could be left out.
std::string spaceWarning(const store::DiskSpace& space, const std::filesystem::path& folder,
                         bool pngs);

}  // namespace rotatebook::cli
