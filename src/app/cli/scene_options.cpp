#include "cli/scene_options.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "base/document/overrides.h"
#include "base/error.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/grid_option.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
#include "store/fingerprint.h"
#include "store/scene_file.h"
#include "store/scene_name.h"

namespace rotatebook::cli {
namespace {

std::string sizeOverride(const std::string& size) {
  std::smatch match;
  if (!std::regex_match(size, match, std::regex("([0-9]{1,6})x([0-9]{1,6})"))) {
    throw InputError("--size " + size + ": not a size; write width x height, for example 640x360");
  }
  return "clip.size=[" + match[1].str() + ", " + match[2].str() + "]";
}

/// Returns `message` with the locations of overrides replaced by the options that the user wrote.
std::string asWritten(std::string message, const std::vector<Shorthand>& shorthands) {
  for (const auto& [option, assignment] : shorthands) {
    const std::string location = document::overrideLocation(assignment) + ": ";
    for (std::size_t at = 0; (at = message.find(location, at)) != message.npos;) {
      message.replace(at, location.size(), option + ": ");
      at += option.size();
    }
  }
  return message;
}

/// Has problems that are found later named by the options that the user wrote, too.
void nameAsWritten(scene::Scene& scene, const std::vector<Shorthand>& shorthands) {
  for (auto& [key, location] : scene.locations) {
    for (const auto& [option, assignment] : shorthands)
      if (location == document::overrideLocation(assignment)) location = option;
  }
}

/// Returns the names of a scene's outputs without endings: its own, and those of its panels'
/// tables.
std::set<std::string> stemsOf(const scene::Scene& scene) {
  std::set<std::string> stems{scene.name};
  for (const auto& csv : store::csvFiles(scene.name + ".csv", scene)) {
    stems.insert(csv.stem().string());
  }
  return stems;
}

/// Throws InputError if no output of `scene` can be named `name`.
void requireUsable(const std::string& name, const scene::Scene& scene) {
  const std::string problem = store::problemOfName(name);
  if (problem.empty()) return;
  throw InputError("the name " + quotedText(name) + " " + problem + ": rename the scene's file" +
                   (name == scene.name ? "" : ", or shorten the panel's label"));
}

}  // namespace

void SceneOptions::addTo(CLI::App& command, bool draws) {
  constexpr const char* kGroup = "Scene";
  const char* pictures = draws ? kGroup : "";
  command
      .add_option("--set", overrides,
                  "Override a key of the scene, e.g. --set simulation.substeps=10; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->group(kGroup);
  command.add_option("--size", size, "Picture size, e.g. 640x360; the same as --set clip.size")
      ->type_name("WxH")
      ->group(pictures);
  command
      .add_option("--grid", grid,
                  "Books side by side, e.g. \"initial.tilt=1e-2,1e-4 x simulation.substeps=1..8\"")
      ->type_name("KEY=VALUES [x KEY=VALUES]")
      ->group(pictures);
  addAllowOutside(command, allowOutside)->group(pictures);
}

std::vector<std::string> SceneOptions::words() const {
  std::vector<std::string> words;
  for (const std::string& assignment : overrides) words.insert(words.end(), {"--set", assignment});
  if (!size.empty()) words.insert(words.end(), {"--size", size});
  if (!grid.empty()) words.insert(words.end(), {"--grid", grid});
  if (allowOutside) words.emplace_back("--allow-outside");
  return words;
}

void SceneOptions::addChecksum(CLI::App& command) {
  command
      .add_option("--scene-checksum", checksums,
                  "Refuse a scene that has changed since 'submit' wrote these checksums")
      ->type_name("XXH128,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group("Scene");
}

scene::Scene SceneOptions::read(const std::string& path, std::vector<Shorthand> shorthands) const {
  scene::Scene read = applied(std::move(shorthands), [&](std::span<const std::string> all) {
    return store::readScene(path, all, allowOutside);
  });
  if (checksums.empty() || std::ranges::count(checksums, store::sceneChecksum(read)) > 0)
    return read;
  throw InputError(
      path + ": has changed since it was submitted; submit it again, into another folder (-o)");
}

scene::Scene SceneOptions::parse(std::string_view text, const std::string& name) const {
  return applied(
      {}, [&](std::span<const std::string> all) { return scene::parseScene(text, name, all); });
}

scene::Scene SceneOptions::applied(std::vector<Shorthand> shorthands, const Reader& reader) const {
  if (!size.empty()) shorthands.push_back({"--size " + size, sizeOverride(size)});
  if (!grid.empty()) {
    for (Shorthand& shorthand : gridShorthands(grid)) shorthands.push_back(std::move(shorthand));
  }
  std::vector<std::string> all = overrides;
  for (const Shorthand& shorthand : shorthands) all.push_back(shorthand.assignment);
  try {
    scene::Scene read = reader(all);
    nameAsWritten(read, shorthands);
    return read;
  } catch (const InputError& error) {
    throw InputError(asWritten(error.what(), shorthands));
  }
}

void addNoExpect(CLI::App& command, bool& noExpect) {
  command
      .add_flag("--no-expect", noExpect,
                "Judge nothing that the scene expects, so that the exit status is 0")
      ->group("Scene");
}

void requireMap(const scene::Scene& scene, const std::string& path) {
  if (scene.map) return;
  throw InputError(path +
                   ": the scene has no [map], which says what to run for each pixel; see "
                   "scenes/maps/ and docs/scene.md");
}

void refuseSameNames(const std::vector<scene::Scene>& scenes) {
  std::map<std::string, std::string> owners;  // The scene that writes outputs of each stem.
  for (const scene::Scene& scene : scenes) {
    for (const std::string& stem : stemsOf(scene)) {
      requireUsable(stem, scene);
      const auto [owner, isNew] = owners.emplace(stem, scene.name);
      if (isNew) continue;
      const std::string both = owner->second == scene.name ? "two scenes are named " + scene.name
                                                           : owner->second + " and " + scene.name +
                                                                 " both write " + stem + ".csv";
      throw InputError(both +
                       "; they would overwrite each other: render them into different folders");
    }
  }
}

}  // namespace rotatebook::cli
