#include "store/scene_file.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "base/document/toml_text.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "picture/named_file.h"
#include "scene/motion_files.h"
#include "scene/scene_text.h"
#include "store/scene_name.h"
#include "system/read_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

/// Returns the names of the scenes in `folder`, without their ending.
std::vector<std::string> sceneNamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    // A link to nothing isn't there, either.
    if (entry.path().extension() == ".toml" && entry.exists(ignored))
      names.push_back(entry.path().stem().string());
  }
  // The first of equally near names is suggested, and the order of a folder is arbitrary.
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void failMissing(const fs::path& path) {
  const std::vector<std::string> names = sceneNamesIn(path.parent_path());
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const auto nearest = nearestName(path.stem().string(), candidates);
  if (!nearest) document::failAt(path.string(), "scene not found");
  const fs::path suggestion = path.parent_path() / fmt::format("{}.toml", *nearest);
  document::failAt(path.string(), fmt::format("scene not found; did you mean {}?",
                                              document::tomlString(suggestion.string())));
}

scene::ReadNamedFile readerOf(const fs::path& folder, bool allowOutside) {
  return [folder, allowOutside](const fs::path& file, std::size_t most) {
    return system::readInput(picture::pathOfNamedFile(folder, file, allowOutside), most);
  };
}

}  // namespace

void readMotionFiles(scene::Scene& scene) {
  const scene::ReadNamedFile readNamedFile = readerOf(scene.folder, scene.allowOutside);
  scene::readMotionFiles(scene, readNamedFile);
  scene::readMeshFiles(scene, readNamedFile);
}

std::string readSceneText(const fs::path& path) {
  try {
    return system::readFileOrInput(path, document::kLongestToml);
  } catch (const InputError& error) {
    document::failAt(system::nameOfInput(path.string()),
                     std::string("can't be read: ") + error.what());
  }
}

void requireScene(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) document::failAt(path.string(), "a folder, not a scene");
  if (!fs::exists(path, ignored)) failMissing(path);
  const std::string name = path.stem().string();
  if (const std::string problem = problemOfName(name); !problem.empty()) {
    document::failAt(path.string(), fmt::format("the scene's name {} {}; rename the file",
                                                document::tomlString(name), problem));
  }
}

scene::Scene readScene(const fs::path& path, std::span<const std::string> overrides,
                       bool allowOutside) {
  if (path != system::kStandardInput) requireScene(path);
  return readScene(path, readSceneText(path), overrides, allowOutside);
}

scene::Scene readScene(const fs::path& path, const std::string& text,
                       std::span<const std::string> overrides, bool allowOutside) {
  const scene::ReadNamedFile readNamedFile = readerOf(path.parent_path(), allowOutside);
  scene::Scene scene =
      scene::parseScene(text, system::nameOfInput(path.string()), overrides, readNamedFile);
  scene.allowOutside = allowOutside;
  scene::readMeshFiles(scene, readNamedFile);
  return scene;
}

}  // namespace rotatebook::store
