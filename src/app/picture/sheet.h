// Many pictures on one: a contact sheet.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image.h"
#include "render/device/device.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Which frames of each scene, and how they are laid out.
struct SheetOptions {
  /// Times in the video, in place of `count`. [s]
  std::vector<double> times{};
  /// Frames of each scene, >= 1, from its first to its last at equal distances; of 1 its poster.
  int count = 12;
  /// Pictures in a row, >= 1; 0 makes as many rows as columns, or one less.
  int columns = 0;
  render::DeviceChoice device{};
};

/// Draws the frames, scene by scene, and beneath each its time, its scene's title, or both, as is
/// needed to tell them apart. Rgba8, opaque. Throws InputError for scenes of differing sizes, for a
/// time that isn't in the clip, and for a sheet of over kMaxPictureSide.
image::Image drawSheet(const std::vector<scene::Scene>& scenes, const SheetOptions& options);

}  // namespace rotatebook::picture
