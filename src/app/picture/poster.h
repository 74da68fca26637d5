// Draws the poster, the picture that represents a clip.
#pragma once

#include <cstdint>
#include <filesystem>

#include "picture/frame_drawer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Returns the frame at the time clip.poster, the last one if the clip ends before; without it, the
/// middle one of the clip's `frames` > 0.
std::int64_t posterFrame(const scene::ClipSettings& clip, std::int64_t frames);

/// Draws frame `frame` and writes it to `path`, with its alpha if `transparent`. Throws
/// MachineError.
void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path);

}  // namespace rotatebook::picture
