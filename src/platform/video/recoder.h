// Codes a clip's pictures anew, in fewer bytes.
#pragma once

#include <filesystem>

#include "video/video_settings.h"

namespace rotatebook::video {

/// Decodes the pictures of the clip `source`, an MP4 of this program, and writes them as the MP4
/// `target` with the crf, preset and threads of `settings`. Size, frame rate, title and comment are
/// those of `settings`, too, and must be the clip's. Throws InputError for a clip that can't be
/// read, or has other pictures; MachineError like VideoWriter.
void recode(const std::filesystem::path& source, const std::filesystem::path& target,
            const VideoSettings& settings);

}  // namespace rotatebook::video
