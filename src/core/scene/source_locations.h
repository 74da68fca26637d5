// Locations in a scene of what can prove wrong only when files and fonts are opened.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Returns the key of that panel's label: "panel.0.label".
inline std::string labelKey(std::size_t panel) {
  return "panel." + std::to_string(panel) + ".label";
}

/// Returns the key of the time of that cue: "cue.0.at".
inline std::string cueKey(std::size_t cue) {
  return "cue." + std::to_string(cue) + ".at";
}

/// Returns the key of that panel's own recording: "panel.0.simulation.file".
inline std::string recordingKey(std::size_t panel) {
  return "panel." + std::to_string(panel) + ".simulation.file";
}

/// Returns the location where the scene states `key`, "FILE:LINE:COLUMN" or "--set KEY=VALUE"; the
/// scene's name if it doesn't state it.
inline std::string locationOf(const Spec& scene, std::string_view key) {
  const auto location = scene.locations.byKey.find(key);
  return location == scene.locations.byKey.end() ? scene.name : location->second;
}

/// Returns what `work` returns. Throws an InputError of it again as "LOCATION: PROBLEM", with the
/// location of `key`.
template <std::invocable Work>
auto atLocationOf(const Spec& scene, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(locationOf(scene, key) + ": " + error.what());
  }
}

}  // namespace rotatebook::scene
