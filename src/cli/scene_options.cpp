#include "cli/scene_options.h"

#include <regex>
#include <set>
#include <utility>

#include "base/error.h"
#include "scene/scene_file.h"

namespace rotatebook::cli {
namespace {

std::string sizeOverride(const std::string& size) {
  std::smatch match;
  if (!std::regex_match(size, match, std::regex("([0-9]{1,6})x([0-9]{1,6})"))) {
    throw InputError("--size " + size + ": not a size; write width x height, for example 640x360");
  }
  return "clip.size=[" + match[1].str() + ", " + match[2].str() + "]";
}

/// `message` in the words that the user wrote.
std::string inUsersWords(const std::string& message, const std::vector<Shorthand>& shorthands) {
  for (const auto& [words, assignment] : shorthands) {
    const std::string place = "--set " + assignment;
    if (message.starts_with(place)) return words + message.substr(place.size());
  }
  return message;
}

}  // namespace

void SceneOptions::addTo(CLI::App& command) {
  command
      .add_option("--set", overrides,
                  "Override a key of the scene, e.g. --set simulation.substeps=10; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command.add_option("--size", size, "Picture size, e.g. 640x360; the same as --set clip.size")
      ->type_name("WxH");
  command.add_flag("--allow-outside", allowOutside,
                   "Let the scene take textures from outside its folder");
}

scene::Scene SceneOptions::read(const std::string& path, std::vector<Shorthand> shorthands) const {
  return applied(std::move(shorthands),
                 [&](std::span<const std::string> all) { return scene::readScene(path, all); });
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
    scene::Scene scene = reader(all);
    scene.allowOutside = allowOutside;
    return scene;
  } catch (const InputError& error) {
    throw InputError(inUsersWords(error.what(), shorthands));
  }
}

void refuseSameNames(const std::vector<scene::Scene>& scenes) {
  std::set<std::string> names;
  for (const scene::Scene& scene : scenes) {
    if (names.insert(scene.name).second) continue;
    throw InputError("two scenes are named " + scene.name +
                     "; they would overwrite each other: render them into different folders");
  }
}

}  // namespace rotatebook::cli
