// Captions and measured events of a clip as WebVTT.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_events.h"

namespace rotatebook::timeline {

/// The first line, by which such a file is known.
inline constexpr std::string_view kVttHead = "WEBVTT rotatebook";

/// Returns an event with its time and motion, in the pictures' language: "4.07 s: flip 1".
std::string eventText(const ClipEvent& event, const scene::Words& words);

/// Returns the scene's captions and a clip's events as WebVTT, by the time of its video. Of scenes
/// with cues each caption stays until the next; each event until shortly before the next, for 3 s
/// at most, and for 0.8 s at least, also where the video ends before.
std::string webVtt(const scene::Scene& scene, const std::vector<ClipEvent>& events,
                   std::int64_t frames);

}  // namespace rotatebook::timeline
