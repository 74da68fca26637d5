// A moment of a motion: a time, or an event of it.
#pragma once

#include <string>

namespace rotatebook::scene {

/// Events of a motion that a scene may name.
enum class Event {
  Start,  ///< t = 0
  Flip,   ///< The spun axis has turned over, as timeline::flipsOf() counts it.
  Nudge,
  Burst,  ///< The motion diverges.
  End,    ///< The clip's end.
};

/// A moment of a motion, by the time from an event to it.
struct Moment {
  Event event = Event::Start;
  int number = 1;       ///< Of a flip or a nudge, from 1.
  double offset = 0;    ///< Of the motion's time; negative before the event. [s]
  std::string label{};  ///< Of the motion; if empty, of the scene's first.

  friend bool operator==(const Moment&, const Moment&) = default;
};

}  // namespace rotatebook::scene
