// Options of the commands that read scenes. Inside the room only.
#pragma once

#include <functional>
#include <optional>
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

/// The values of --set, --size, --grid, --allow-outside and --scene-checksum.
struct SceneOptions {
  std::vector<std::string> overrides;
  std::string size;  ///< "WxH" or empty.
  /// "KEY=VALUES" or "KEY=VALUES x KEY=VALUES", columns first; empty without. VALUES are
  /// "1,10,100", whole numbers "1..8", or a list or a table as a scene has it. What the scene
  /// expects of its own motion is left out then.
  std::string grid;
  bool allowOutside = false;
  std::vector<std::string> checksums;  ///< Of the scenes that are taken; all if there are none.

  /// Adds the options. Those of pictures are left out of the help of a command that `draws` none,
  /// but taken there, too, as scripts pass the same options to several commands.
  void addTo(CLI::App& command, bool draws = true);
  /// Throws InputError that ends with `remedy` for --size, where what is drawn has another size.
  void refuseSize(const std::string& remedy) const;
  /// Returns the words of a command line with these options, but for --scene-checksum.
  std::vector<std::string> words() const;
  /// Adds --scene-checksum.
  void addChecksum(CLI::App& command);
  /// Reads a scene with these options applied, then `shorthands`. A scene of a single motion that
  /// doesn't state the section of `unstated`, "study={}", gets it. Throws InputError.
  scene::Scene read(const std::string& path, std::vector<Shorthand> shorthands = {},
                    const std::optional<Shorthand>& unstated = {}) const;
  /// Reads a scene likewise from text, without the files that it names; it is called `name`.
  scene::Scene parse(std::string_view text, const std::string& name) const;

 private:
  using Reader = std::function<scene::Scene(std::span<const std::string> overrides)>;
  /// Returns the overrides, then those of `after`.
  std::vector<std::string> assignments(const std::vector<Shorthand>& after) const;
  scene::Scene applied(std::vector<Shorthand> shorthands, const Reader& reader) const;
};

/// Adds --no-expect, which leaves whatever scenes expect unjudged.
void addNoExpect(CLI::App& command, bool& noExpect);

/// Throws InputError if the scene, read from `path`, has no map.
void requireMap(const scene::Scene& scene, const std::string& path);

/// Throws InputError if two of `scenes` would write the same file, or if
/// store::problemOfName() refuses a name.
void refuseSameNames(const std::vector<scene::Scene>& scenes);

}  // namespace rotatebook::cli
