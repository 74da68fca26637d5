// Moments of a motion as values of keys. Inside the room only.
#pragma once

#include <string>

#include "base/document/value_reader.h"
#include "scene/moment.h"

namespace rotatebook::scene {

inline constexpr const char* kExpectedMoments =
    "a time of the motion, 0 or more seconds, or an event such as \"flip 1\", \"nudge 2\", "
    "\"burst\", "
    "\"end\" or \"0.5 s before flip 1\", with panels \"flip 1 of LABEL\"";

/// Returns whether the value is a text that states no time, and so an event.
bool isOfEvent(const document::ValueReader& value);
/// Reads a time, or an event and the time before or after it.
Moment momentFrom(const document::ValueReader& value);
/// Returns the moment as TOML.
std::string momentText(const Moment& moment);
/// Returns an event without the time before or after it, and its motion: "flip 1".
std::string eventText(const Moment& moment);

}  // namespace rotatebook::scene
