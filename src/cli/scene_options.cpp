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
  std::vector<std::string> all = overrides;
  if (!size.empty()) all.push_back(sizeOverride(size));
  return scene::readScene(path, all);
}

}  // namespace rotatebook::cli
