// Disk space that a clip needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::store {

/// Disk space needed and available.
struct DiskSpace {
  double needed = 0;  ///< An estimate, rather too high than too low. [bytes]
  double free = 0;    ///< Available to this user. [bytes]
};

/// The files of a clip that a render will write, besides its tables and its poster.
struct FilesToWrite {
  std::int64_t pngs = 0;    ///< PNG frames that don't exist yet.
  std::int64_t frames = 0;  ///< Frames in each video.
  std::vector<video::VideoFormat> formats{};
};

/// Estimates the space that `files` need, in whole blocks of the file system, from sizes measured
/// on the shipped scenes; and reads the free space of `folder`, which must exist. Throws
/// MachineError.
DiskSpace diskSpace(const scene::Scene& scene, const FilesToWrite& files,
                    const std::filesystem::path& folder);

/// Returns "about 12 GB are needed in out and 3.2 GB are free: ..."; empty if there is enough. If
/// `pngs` are written, it advises to leave them out.
std::string spaceWarning(const DiskSpace& space, const std::filesystem::path& folder, bool pngs);

}  // namespace rotatebook::store
