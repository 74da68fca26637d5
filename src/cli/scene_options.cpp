#include "cli/scene_options.h"

#include <regex>

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
std::string withSizeOption(const std::string& message, const std::string& assignment,
                           const std::string& size) {
  const std::string place = "--set " + assignment;
  return message.starts_with(place) ? "--size " + size + message.substr(place.size()) : message;
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
}

scene::Scene SceneOptions::read(const std::string& path) const {
  if (size.empty()) return scene::readScene(path, overrides);
  std::vector<std::string> all = overrides;
  all.push_back(sizeOverride(size));
  try {
    return scene::readScene(path, all);
  } catch (const InputError& error) {
    throw InputError(withSizeOption(error.what(), all.back(), size));
  }
}

}  // namespace rotatebook::cli
