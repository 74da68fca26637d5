// Events of a clip in words, as captions of its player. Inside the room only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/frame_rate.h"

namespace rotatebook::page {

/// A measured event of a clip's motions; of several motions its words name the one.
struct Event {
  std::int64_t frame = 0;  ///< The first frame that shows it.
  std::string words;       ///< "4.07 s: turned over, first time"; the time is the simulated one.
};

/// Returns "4.07 s: ", which an event's words begin with.
std::string headOf(double time);

/// Returns the events as WebVTT, by the clip's own time. Each stays until shortly before the next,
/// for 3 s at most, and for 0.8 s at least.
std::string webVtt(const std::vector<Event>& events, const FrameRate& rate, std::int64_t frames);

}  // namespace rotatebook::page
