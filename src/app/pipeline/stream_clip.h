// Streaming of a scene's pictures to another program, while they are drawn.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "picture/device_choice.h"
#include "picture/looks.h"
#include "pipeline/draw_frames.h"
#include "scene/scene.h"
#include "store/clip_files.h"
#include "system/file_descriptor.h"
#include "timeline/clip_motion.h"

namespace rotatebook::pipeline {

/// Kinds of streams: the pictures one after the other.
enum class StreamFormat {
  Y4m,  ///< video::Y4mStream
  Png,  ///< The files of the frames, byte for byte.
  Raw,  ///< Rows from the top, RGB of 8 bits, or RGBA if the scene's background is transparent.
};

/// Names of the formats, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kStreamNames{"y4m", "png", "raw"};

struct StreamOptions {
  StreamFormat format = StreamFormat::Y4m;
  std::optional<store::FrameRange> frames{};  ///< Only these; all by default.
  picture::DeviceChoice device{};
};

/// Draws `motion`, the scene's, and writes its pictures to `output`, which messages call `name`.
/// Returns the number of frames. The bytes are the same on any number of cores. Throws InputError
/// if the format can't hold the scene's size or transparency, or the frames don't exist;
/// MachineError if they can't be drawn or written. Nothing is written but to `output`.
std::int64_t streamClip(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const StreamOptions& options, const system::FileDescriptor& output,
                        const std::filesystem::path& name,
                        const std::function<void(RenderProgress)>& progress,
                        const picture::TextureFiles& textures = {});

}  // namespace rotatebook::pipeline
