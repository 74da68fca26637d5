// Where a scene states what proves wrong only when files and fonts are opened.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The keys that Scene::locations knows, sections before a dot, but for those of labelKey().
inline constexpr std::string_view kLocatedKeys[] = {
    "title", "caption", "panel", "book.front", "book.spine", "book.back", "overlay.font"};

/// "panel.0.label": the key of that panel's label.
std::string labelKey(std::size_t panel);

/// "FILE:LINE:COLUMN", or "--set KEY=VALUE", where the scene states `key`; its name if it doesn't.
std::string locationOf(const Scene& scene, std::string_view key);

/// What `work` returns. An InputError of it is thrown anew as "PLACE: PROBLEM", with the location
/// of `key`.
template <std::invocable Work>
auto atLocationOf(const Scene& scene, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(locationOf(scene, key) + ": " + error.what());
  }
}

}  // namespace rotatebook::scene
