#include "scene/scene_file.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/read_file.h"
#include "scene/nearest_name.h"
#include "scene/toml_text.h"
#include "scene/toml_tree.h"

namespace rotatebook::scene {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> sceneNamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  }
  // The order of a folder is the file system's whim, and of two names as near the first is
  // suggested.
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void failMissing(const fs::path& path) {
  const std::vector<std::string> names = sceneNamesIn(path.parent_path());
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  fs::path wanted = path.filename();
  if (!wanted.has_extension()) wanted += ".toml";
  const auto nearest = nearestName(wanted.string(), candidates);
  if (!nearest) failAt(path.string(), "scene not found");
  const fs::path suggestion = path.parent_path() / *nearest;
  failAt(path.string(), "scene not found; did you mean " + tomlString(suggestion.string()) + "?");
}

}  // namespace

std::string readSceneText(const fs::path& path) {
  try {
    return readFile(path, kLongestToml);
  } catch (const InputError& error) {
    failAt(path.string(), std::string("can't be read: ") + error.what());
  }
}

Scene readScene(const fs::path& path, std::span<const std::string> overrides) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) failAt(path.string(), "a folder, not a scene");
  if (!fs::exists(path, ignored)) failMissing(path);
  return parseScene(readSceneText(path), path, overrides);
}

}  // namespace rotatebook::scene
