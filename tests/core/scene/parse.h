// Scenes from a few lines, and what is said of wrong ones.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {

/// All that a scene needs; the lines under test come before it.
inline constexpr const char* kSpin = "[initial]\nangular_velocity = [0, 0, 6]\n";

/// The scene of `lines` and a spin.
inline Scene sceneFrom(const std::string& lines, const std::vector<std::string>& overrides = {}) {
  return parseScene(lines + "\n" + kSpin, "a.toml", overrides);
}

/// The message about a whole text, "no error" if there is none.
inline std::string errorOfText(const std::string& text,
                               const std::vector<std::string>& overrides = {}) {
  try {
    parseScene(text, "a.toml", overrides);
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// The message about `lines` with a spin.
inline std::string errorOf(const std::string& lines,
                           const std::vector<std::string>& overrides = {}) {
  return errorOfText(lines + "\n" + kSpin, overrides);
}

}  // namespace rotatebook::scene
