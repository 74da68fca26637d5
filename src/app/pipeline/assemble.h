// Assembly of frames on the disk into a video.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "pipeline/render_clip.h"

namespace rotatebook::pipeline {

/// Colours that aren't as some frames say, as image::lostColoursOf() has them.
struct LostColours {
  std::string text;
  std::int64_t frames = 0;
};

/// The frames of which a video was made.
struct Assembled {
  store::FrameRange frames;
  std::optional<std::int64_t> sceneFrames{};  ///< The scene's count; none without a scene.
  std::int64_t unlisted = 0;  ///< Frames without a checksum, though others have one.
  std::vector<LostColours> lost{};

  /// Returns whether the scene has other frames, too.
  bool isPart() const { return sceneFrames && frames != store::FrameRange{0, *sceneFrames}; }
};

/// Makes `video`, in the format that its ending names, from the frames in `folder`, with the
/// settings of the scene.toml beside them: byte for byte the file that the render of these frames
/// would make. Frames without a scene.toml need a `frameRate`, others must have none. Calls
/// `progress`, which may be empty, after each frame. Throws InputError if there are no frames, one
/// is missing, differs in size or from its checksum in frames.xxh128, or has transparency that the
/// video would lose, or if rate or format are missing, or, if the clip must be `whole`, frames of
/// the scene are; MachineError if a frame can't be read or the whole clip is being rendered there.
/// A frame without a checksum must be a PNG whose own checksums are right.
Assembled assemble(const std::filesystem::path& folder, const std::filesystem::path& video,
                   std::optional<FrameRate> frameRate,
                   const std::function<void(RenderProgress)>& progress, bool whole = false);

}  // namespace rotatebook::pipeline
