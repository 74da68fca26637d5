// Draws a contact sheet: many frames on one picture.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image.h"
#include "render/device/device.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// The frames of each scene, and their layout.
struct SheetOptions {
  /// Times in the video; they replace `count` unless empty. [s]
  std::vector<double> times{};
  /// Number of frames of each scene, >= 1, evenly spaced from the first to the last; 1 draws the
  /// poster.
  int count = 12;
  /// Pictures in a row, >= 1; 0 makes as many rows as columns, or one row fewer.
  int columns = 0;
  render::DeviceChoice device{};
};

/// Draws the frames, scene by scene, and below each its time in the video, its scene's title, or
/// both, as necessary to tell them apart. Returns an opaque Rgba8 picture. Throws InputError if
/// scenes differ in size, if a time isn't in the clip, and if the frames would have more than 250
/// million pixels or a side of the sheet more than kMaxPictureSide.
image::Image drawSheet(const std::vector<scene::Scene>& scenes, const SheetOptions& options);

}  // namespace rotatebook::picture
