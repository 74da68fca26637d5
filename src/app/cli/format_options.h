// Options about the videos of a clip. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::cli {

/// Adds --format, with the formats' names.
CLI::Option* addFormats(CLI::App& command, std::vector<std::string>& names);

/// Returns the formats that --format names, each once, without MP4 if `noMp4`. Throws InputError.
std::vector<video::VideoFormat> videoFormatsOf(const std::vector<std::string>& names, bool noMp4);

/// Throws InputError if a video of a scene would lose its transparency.
void refuseOpaque(const scene::Scene& scene, const std::vector<video::VideoFormat>& formats);

}  // namespace rotatebook::cli
