// A motion as an animated file for other programs: glTF 2.0 in one file (GLB), or USDZ.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/interchange/turning.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

/// An animated file, and what is to be said of it.
struct MotionFile {
  std::string bytes;
  std::size_t keys = 0;
  double seconds = 0;   ///< From the first key to the last.
  double errorDeg = 0;  ///< As Turning has it.
  /// The most that a corner is off halfway between two keys, of a body that deforms. [m]
  std::optional<double> errorM{};
  std::vector<std::string> notes{};
};

/// Returns the motion with this index as a GLB: the body with its materials, its attitude in the
/// world at the video's times, and the scene's camera, whose moves are an animation, too. All of
/// the body is bound to one joint, as some programs play nothing else; if it deforms, it has 24
/// morph targets, by which its corners move. `asset.extras` has the scene's text, the panel, and
/// the checksum of the clip's motions. Throws InputError for a grid, a map, and tangents of a body
/// that deforms; else as timeline::simulateScene() and picture::loadLooks() do.
MotionFile motionGlb(const scene::Scene& scene, std::size_t motion, const KeyOptions& options);

/// Returns it likewise as a USDZ, of one mesh in one layer, as text. Its turning is interpolated as
/// a GLB's LINEAR one. Throws InputError for tangents, and a body that deforms.
MotionFile motionUsdz(const scene::Scene& scene, std::size_t motion, const KeyOptions& options);

/// Returns whether a file is one of these, by its beginning.
bool isMotionFile(std::string_view bytes);

}  // namespace rotatebook::interchange
