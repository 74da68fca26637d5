// A warning about disk space.
#pragma once

#include <filesystem>
#include <string>

#include "store/disk_space.h"

namespace rotatebook::report {

/// Returns "about 12 GB are needed in out and 3.2 GB are free: ..."; empty if there is enough. If
/// `pngs` are written, it advises to leave them out.
std::string spaceWarning(const store::DiskSpace& space, const std::filesystem::path& folder,
                         bool pngs);

}  // namespace rotatebook::report
