// From frames on the disk to a video.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "base/frame_rate.h"
#include "pipeline/render_clip.h"

namespace rotatebook::pipeline {

/// What a video was made of.
struct Assembled {
  store::FrameRange frames;
  std::optional<std::int64_t> sceneFrames{};  ///< How many the scene has; none from elsewhere.

  /// Whether the scene has others, too.
  bool isPart() const { return sceneFrames && frames != store::FrameRange{0, *sceneFrames}; }
};

/// Makes `video`, of the format that its ending names, from the frames in `folder`, with the
/// settings of the scene.toml beside them: the same file, byte for byte, as the render that
/// drew them, whole or in part. Frames from elsewhere need a `frameRate`; it is an error to give
/// one where a scene.toml tells. Throws InputError: no frames, one missing, one with another
/// checksum than frames.xxh128 has for it, differing sizes, no rate, no format; MachineError if a
/// frame can't be read, or the whole clip is being rendered there.
Assembled assemble(const std::filesystem::path& folder, const std::filesystem::path& video,
                   std::optional<FrameRate> frameRate,
                   const std::function<void(RenderProgress)>& progress);

}  // namespace rotatebook::pipeline
