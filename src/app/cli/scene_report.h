// JSON reports on scene files. Inside the room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rotatebook::cli {

/// A scene file that was read.
struct SceneFile {
  std::filesystem::path path;
  std::optional<scene::Scene> scene{};  ///< Nothing if it can't be read.
  /// Of its clip, which ends early if its motion diverges; nothing if it wasn't simulated.
  std::optional<std::int64_t> frames{};
  std::vector<std::string> notes{};   ///< On what is likely a slip in it.
  std::vector<std::string> errors{};  ///< Why the scene isn't usable; empty if it is.
};

/// Prints one JSON object: for each file whether it can be used, errors, notes, frames
/// and panels.
void reportChecksAsJson(const std::vector<SceneFile>& files, std::ostream& out);

/// Prints one JSON object: for each file errors, name, title, length and size of the clip.
void reportListAsJson(const std::vector<SceneFile>& files, std::ostream& out);

}  // namespace rotatebook::cli
