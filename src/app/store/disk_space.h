// How much room a clip takes on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::store {

struct DiskSpace {
  double needed = 0;  ///< About, and rather more than less. [bytes]
  double free = 0;    ///< For this user. [bytes]
};

/// What of a clip is to be written, beside its table and its poster.
struct FilesToWrite {
  std::int64_t pngs = 0;    ///< PNG frames that aren't there yet.
  std::int64_t frames = 0;  ///< Of each video.
  std::vector<video::VideoFormat> formats{};
};

/// What these take, from what shipped scenes take, whole blocks of the file system counted; and
/// what is free in `folder`, which exists. Throws MachineError.
DiskSpace diskSpace(const scene::Scene& scene, const FilesToWrite& files,
                    const std::filesystem::path& folder);

}  // namespace rotatebook::store
