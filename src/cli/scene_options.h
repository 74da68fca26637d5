// Options that every command with a scene takes.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/scene.h"

namespace rotatebook::cli {

/// --set and --size.
struct SceneOptions {
  std::vector<std::string> overrides;
  std::string size;  ///< "WxH" or empty.

  void addTo(CLI::App& command);
  /// Reads a scene with these options applied. Throws InputError.
  scene::Scene read(const std::string& path) const;
};

}  // namespace rotatebook::cli
