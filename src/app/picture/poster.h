// The one picture that stands for a clip.
#pragma once

#include <cstdint>
#include <filesystem>

#include "picture/frame_drawer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// The frame at [clip] poster, or else in the middle of the clip's `frames` > 0; the last one if
/// the clip ends before.
std::int64_t posterFrame(const scene::ClipSettings& clip, std::int64_t frames);

/// Draws that frame and writes it to `path`, with its alpha if `transparent`. Throws MachineError.
void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path);

}  // namespace rotatebook::picture
