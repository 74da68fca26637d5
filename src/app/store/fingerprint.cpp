#include "store/fingerprint.h"

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/text.h"
#include "base/version.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
#include "system/build_id.h"
#include "system/file_checksum.h"
#include "system/read_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using Entries = Manifest::Entries;

constexpr std::size_t kMaxDifferences = 3;

/// Adds all values below `node` to `values` under their full keys: "clip.duration",
/// "panels[0].label".
void flatten(const document::TomlNode& node, const std::string& key, Entries& values) {
  if (const auto* table = std::get_if<document::TomlNode::Table>(&node.value)) {
    for (const document::TomlEntry& entry : *table) {
      flatten(entry.node, key.empty() ? entry.key : key + '.' + entry.key, values);
    }
  } else if (const auto* array = std::get_if<document::TomlNode::Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      flatten((*array)[i], fmt::format("{}[{}]", key, i), values);
    }
  } else {
    values[key] = describe(node);
  }
}

/// Returns the values in `sceneText` by key; none if it isn't TOML, as an edited file may be.
Entries valuesOf(const std::string& sceneText) {
  Entries values;
  try {
    flatten(document::parseToml(sceneText, kSceneCopyName), "", values);
  } catch (const InputError&) {
    values.clear();
  }
  return values;
}

/// Adds a text to `found` for each key whose values differ.
void addDifferences(const Entries& there, const Entries& here, std::vector<std::string>& found) {
  constexpr const char* kNone = "missing";
  Entries both = there;
  both.insert(here.begin(), here.end());
  for (const auto& [key, unused] : both) {
    const auto a = there.find(key), b = here.find(key);
    const std::string old = a != there.end() ? a->second : kNone;
    const std::string now = b != here.end() ? b->second : kNone;
    if (old != now) found.push_back(fmt::format("{} is {} there, {} here", key, old, now));
  }
}

/// Returns the first kMaxDifferences of `found` and the number of others.
std::string shortList(std::vector<std::string> found) {
  const std::size_t count = found.size();
  if (count > kMaxDifferences) {
    found.resize(kMaxDifferences);
    found.push_back(fmt::format("and {} more", count - kMaxDifferences));
  }
  return joined(found, "; ");
}

/// The beginning of a film's record.
constexpr std::string_view kHeadOfFilm = "# The film of a map.\n";

/// Returns a checksum of this program and of what its results depend on.
std::string checksumWithProgram(const std::string& settings) {
  return checksumOf(fmt::format("{}\n{}\n{}", kVersion, system::buildId(), settings));
}

}  // namespace

std::string sceneChecksum(const scene::Scene& scene) {
  return checksumOf(sceneText(scene));
}

Entries fingerprint(const scene::Scene& scene, const Entries& textures, const Drawing& drawing) {
  Entries made = textures;
  made["program"] = std::string("rotatebook ") + kVersion;
  // A change of the program's code may change pictures without changing its version.
  made["build"] = system::buildId();
  made["renderer"] = drawing.renderer;
  made["test frame"] = drawing.testFrame;
  made["scene"] = sceneChecksum(scene);
  return made;
}

std::string studySceneChecksum(const scene::Scene& scene) {
  return checksumOf(studyRunsText(scene));
}

std::string recordOfFilm(const scene::Scene& scene) {
  return std::string(kHeadOfFilm) + sceneText(scene);
}

bool isRecordOfFilm(std::string_view text) {
  return text.starts_with(kHeadOfFilm);
}

std::string filmFingerprint(const scene::Scene& scene) {
  return checksumWithProgram(sceneText(scene));
}

std::string mapFingerprint(const scene::Scene& scene) {
  return checksumWithProgram(checksumOf(mapRunsText(scene)));
}

std::string differences(const fs::path& folder, const Entries& there, const Entries& made,
                        const scene::Scene& scene) {
  Entries old = there, now = made;
  std::vector<std::string> found;
  const std::string record = system::readFileOrEmpty(folder / kSceneCopyName);
  if (old["scene"] != now["scene"] && !record.empty()) {
    addDifferences(valuesOf(record), valuesOf(sceneText(scene)), found);
    old.erase("scene");
    now.erase("scene");
  }
  addDifferences(old, now, found);
  return shortList(std::move(found));
}

std::string sceneChecksumOf(const fs::path& folder, const fs::path& file) {
  const auto manifest = readManifest(folder);
  if (!manifest || !fs::is_regular_file(file)) return "";
  std::vector<Manifest::Render> renders = manifest->others;
  renders.push_back(manifest->own);
  for (const Manifest::Render& render : renders) {
    const auto known = render.files.find(file.filename().string());
    const auto scene = render.made.find("scene");
    if (known == render.files.end() || scene == render.made.end()) continue;
    return system::checksumOfFile(file) == known->second ? scene->second : "";
  }
  return "";
}

}  // namespace rotatebook::store
