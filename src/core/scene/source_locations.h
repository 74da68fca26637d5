// Locations in a scene of what can prove wrong only when files and fonts are opened, and of keys
// whose default depends on another.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The keys that Spec::locations may have, sections before a dot, besides those of labelKey(),
/// cueKey(), recordingKey() and kDependentKeys.
inline constexpr std::string_view kLocatedKeys[] = {
    "title",      "caption",   "body",         "panel",           "grid",      "book.front",
    "book.spine", "book.back", "overlay.font", "simulation.file", "clip.speed"};

/// A key whose default depends on the value of another.
struct DependentKey {
  std::string_view key, of;
};
inline constexpr DependentKey kDependentKeys[] = {{"simulation.integrator", "simulation.model"},
                                                  {"body.size", "body.shape"},
                                                  {"body.mass", "body.shape"},
                                                  {"body.dimensions", "body.shape"},
                                                  {"body.size", "body.part"},
                                                  {"body.mass", "body.part"}};

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
  const auto location = scene.locations.find(key);
  return location == scene.locations.end() ? scene.name : location->second;
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
