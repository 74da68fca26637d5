// The frame of a clip's poster, the picture that represents it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "scene/scene.h"

namespace rotatebook::scene {

/// Returns the frame at the time clip.poster, the last one if the clip ends before; without it, the
/// middle one of the clip's `frames` > 0.
inline std::int64_t posterFrame(const ClipSettings& clip, std::int64_t frames) {
  if (!clip.poster) return frames / 2;
  return std::min(clip.frameRate.framesIn(*clip.poster), frames - 1);
}

}  // namespace rotatebook::scene
