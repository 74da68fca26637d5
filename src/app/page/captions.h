// Events of a clip in words, as captions of its player. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "page/motion_data.h"

namespace rotatebook::page {

/// A measured event of a clip's motions.
struct Event {
  std::int64_t frame = 0;  ///< The first frame that shows it.
  std::string words;       ///< "4.07 s: turned over, first time"; the time is the simulated one.
};

/// Returns the events of all motions in the order of their frames: each half-turn, nudge and
/// divergence, and at the end that a book never turned over. Events of several motions name them by
/// their labels.
std::vector<Event> eventsOf(const std::vector<Motion>& motions, std::int64_t frames);

/// Returns the events as WebVTT, by the clip's own time. Each stays until shortly before the next,
/// for 3 s at most, and for 0.8 s at least.
std::string webVtt(const std::vector<Event>& events, const FrameRate& rate, std::int64_t frames);

}  // namespace rotatebook::page
