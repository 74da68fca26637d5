// A motion as an animated glTF 2.0 file, for other programs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "interchange/turning.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

/// An animated file, and what is to be said of it.
struct MotionGlb {
  std::string bytes;
  std::size_t keys = 0;
  double seconds = 0;   ///< From the first key to the last.
  double errorDeg = 0;  ///< The most that it is off the motion halfway between two keys.
  std::vector<std::string> notes{};
};

/// The beginning of the document in each such file.
inline constexpr const char* kGlbBeginning = R"({"asset":{"generator":"rotatebook )";

/// Returns the motion with this index as a file: the body with its materials, its attitude in the
/// world at the video's times, and the scene's camera, whose moves are an animation, too. All of
/// the body is bound to one joint, as some programs play nothing else. `asset.extras` has the
/// scene's text, the panel, and the checksum of the clip's motions. Throws InputError for a grid, a
/// map, and a body that deforms, as by steps that stretch it; else as timeline::simulateScene() and
/// picture::loadLooks() do.
MotionGlb motionGlb(const scene::Scene& scene, std::size_t motion, const GlbOptions& options);

}  // namespace rotatebook::interchange
