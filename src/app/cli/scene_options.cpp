#include "cli/scene_options.h"

#include <map>
#include <regex>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "document/overrides.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
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
  addAllowOutside(command, allowOutside)->group(pictures);
}

scene::Scene SceneOptions::read(const std::string& path, std::vector<Shorthand> shorthands) const {
  return applied(std::move(shorthands), [&](std::span<const std::string> all) {
    return store::readScene(path, all, allowOutside);
  });
}

scene::Scene SceneOptions::parse(std::string_view text, const std::string& name) const {
  return applied(
      {}, [&](std::span<const std::string> all) { return scene::parseScene(text, name, all); });
}

scene::Scene SceneOptions::applied(std::vector<Shorthand> shorthands, const Reader& reader) const {
  if (!size.empty()) shorthands.push_back({"--size " + size, sizeOverride(size)});
  std::vector<std::string> all = overrides;
  for (const Shorthand& shorthand : shorthands) all.push_back(shorthand.assignment);
  try {
    return reader(all);
  } catch (const InputError& error) {
    throw InputError(asWritten(error.what(), shorthands));
  }
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
