// Scenes from a few lines, and what is said of wrong ones.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "physics/integrators/integrator_table.h"
#include "scene/overlays.h"
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

/// The integrators of `model`, or all, as messages list them.
inline std::string listOfIntegrators(std::string_view lastWord,
                                     std::optional<physics::Model> model = {}) {
  std::vector<std::string_view> words;
  for (const physics::IntegratorRow& row : physics::integratorTable()) {
    if (!model || physics::steppingOf(*model, row.integrator)) words.push_back(row.word);
  }
  return quotedList(words, lastWord);
}

/// The overlays as messages list them.
inline std::string listOfOverlays(std::string_view lastWord) {
  std::vector<std::string_view> words;
  for (const OverlayRow& row : kOverlayRows) words.push_back(row.name);
  return quotedList(words, lastWord);
}

}  // namespace rotatebook::scene
