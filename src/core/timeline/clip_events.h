// The measured events of a clip's motions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// A measured event of one of a clip's motions.
struct ClipEvent {
  std::int64_t frame = 0;  ///< The first frame that shows it.
  double time = 0;         ///< Of the motion. [s]
  std::string label;       ///< The motion's; empty without panels.
  std::string words;       ///< "flip 1", in the pictures' language.
};

/// Returns the events of all motions in the order of their frames: each half-turn, nudge and
/// divergence, and at the end that a body never turned over. Of a grid, whose books have too many,
/// returns none.
std::vector<ClipEvent> eventsOf(const scene::Scene& scene, const ClipMotion& motion);

}  // namespace rotatebook::timeline
