// Options of the commands that read scenes. Inside the room only.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/scene.h"

namespace rotatebook::cli {

/// An option that is short for an override of the scene.
struct Shorthand {
  std::string option;      ///< As the user wrote it: "--size 640x360"; messages name it so.
  std::string assignment;  ///< "clip.size=[640, 360]"
};

/// The values of --set, --size and --allow-outside.
struct SceneOptions {
  std::vector<std::string> overrides;
  std::string size;  ///< "WxH" or empty.
  bool allowOutside = false;

  /// Adds the options. Those of pictures are left out of the help of a command that `draws` none,
  /// but taken there, too, as scripts pass the same options to several commands.
  void addTo(CLI::App& command, bool draws = true);
  /// Reads a scene with these options applied, then `shorthands`. Throws InputError.
  scene::Scene read(const std::string& path, std::vector<Shorthand> shorthands = {}) const;
  /// Reads a scene likewise from text; it is named `name`.
  scene::Scene parse(std::string_view text, const std::string& name) const;

 private:
  using Reader = std::function<scene::Scene(std::span<const std::string> overrides)>;
  scene::Scene applied(std::vector<Shorthand> shorthands, const Reader& reader) const;
};

/// Throws InputError if two of `scenes` would write the same file, or if
/// store::problemOfName() refuses a name.
void refuseSameNames(const std::vector<scene::Scene>& scenes);

}  // namespace rotatebook::cli
