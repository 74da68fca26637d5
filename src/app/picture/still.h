// Draws one picture of a scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "image/png_file.h"
#include "render/device/device.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::picture {

/// Returns the frame nearest to `time` in the video. [s] Throws InputError if the clip doesn't
/// contain that time.
std::int64_t frameAt(const scene::Scene& scene, const timeline::ClipMotion& motion, double time);

/// A frame of a clip.
struct Still {
  std::int64_t frame = 0;  ///< Its index.
  image::Image picture;
};

/// Draws the frame nearest to `time` in the video (0 to the clip's end [s]), without it the
/// poster's. Throws InputError if there is no such frame, MachineError if it can't be drawn.
Still drawStill(const scene::Scene& scene, std::optional<double> time,
                const render::DeviceChoice& device = {});

/// Writes drawStill() to `path`; returns the frame's index. Throws MachineError, too, if it can't
/// be written.
std::int64_t renderStill(const scene::Scene& scene, std::optional<double> time,
                         const std::filesystem::path& path,
                         const render::DeviceChoice& device = {});

}  // namespace rotatebook::picture
