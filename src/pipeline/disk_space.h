// How much room a clip takes on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::pipeline {

struct DiskSpace {
  double needed = 0;  ///< About, and rather more than less. [bytes]
  double free = 0;    ///< For this user. [bytes]
};

/// Of `frames` frames as PNGs, if `png`, and in videos, from what the shipped scenes take a pixel;
/// and what is free in `folder`, which exists. Throws MachineError.
DiskSpace diskSpace(const scene::Scene& scene, std::int64_t frames, bool png,
                    const std::vector<video::VideoFormat>& formats,
                    const std::filesystem::path& folder);

}  // namespace rotatebook::pipeline
