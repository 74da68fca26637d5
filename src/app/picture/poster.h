// Draws the poster, the picture that represents a clip.
#pragma once

#include <cstdint>
#include <filesystem>

#include "picture/frame_drawer.h"

namespace rotatebook::picture {

/// Draws frame `frame` and writes it to `path`, with its alpha if `transparent`. Throws
/// MachineError.
void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path);

}  // namespace rotatebook::picture
