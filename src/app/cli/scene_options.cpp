#include "cli/scene_options.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <regex>
#include <set>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "base/document/overrides.h"
#include "base/document/toml_text.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/text.h"
#include "cli/clip_options.h"
#include "cli/commands.h"
#include "scene/grid_settings.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
#include "store/fingerprint.h"
#include "store/scene_file.h"
#include "store/scene_name.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

std::string sizeOverride(const std::string& size) {
  std::smatch match;
  if (!std::regex_match(size, match, std::regex("([0-9]{1,6})x([0-9]{1,6})"))) {
    throw InputError("--size " + size + ": not a size; write width x height, for example 640x360");
  }
  return fmt::format("clip.size=[{}, {}]", match[1].str(), match[2].str());
}

std::string optionText(const std::string& text) {
  constexpr std::size_t kMaxShown = 200;
  return "--grid " + oneLine(text, kMaxShown);
}

[[noreturn]] void fail(const std::string& text, const std::string& problem) {
  throw InputError(optionText(text) + ": " + problem);
}

/// Returns a value as TOML: words in quotes.
std::string tomlOf(const std::string& value, const std::string& option) {
  if (value.empty()) fail(option, "a value is empty; write values with commas between them");
  return document::parseTomlValue(value, "") ? value : document::tomlString(value);
}

/// Returns the list of the whole numbers `first` to `last`, each with `unit`, if there is one.
std::string wholeNumbers(std::int64_t first, std::int64_t last, const std::string& unit,
                         const std::string& option) {
  const std::string after = unit.empty() ? "" : " " + unit;
  const std::string range = fmt::format("{0}{2}..{1}{2}", first, last, after);
  if (first > last) fail(option, range + " runs downward; write the smaller number first");
  if (last - first >= static_cast<std::int64_t>(scene::kMaxGridSide)) {
    fail(option, fmt::format("{} has {} values; a side has up to {}: list some, such as 1,2,4,8",
                             range, last - first + 1, scene::kMaxGridSide));
  }
  std::vector<std::string> list;
  for (std::int64_t i = first; i <= last; ++i)
    list.push_back(tomlOf(std::to_string(i) + after, option));
  return fmt::format("values = [{}]", joined(list));
}

/// Returns the keys of an axis that state its values.
std::string valuesOf(const std::string& values, const std::string& option) {
  static const std::regex kRange(R"((-?[0-9]{1,9})\s*([^\s\d.,]*)\.\.(-?[0-9]{1,9})\s*\2)");
  if (values.starts_with('[') || values.starts_with('{')) {
    if (document::parseTomlValue(values, "")) {
      return values[0] == '[' ? "values = " + values : values.substr(1, values.size() - 2);
    }
    fail(option, values +
                     " isn't TOML; write a list such as [1, 10] or a table such as "
                     "{ from = 1, to = 100, count = 5 }");
  }
  std::smatch range;
  if (std::regex_match(values, range, kRange)) {
    return wholeNumbers(std::stoll(range[1]), std::stoll(range[3]), range[2], option);
  }
  if (values.find("..") != values.npos) {
    fail(option, values +
                     " is no range of whole numbers, such as 1..8, or 1 deg..3 deg with a unit at "
                     "both ends; list other numbers, such as 0.1,1,10");
  }
  return fmt::format("values = [{}]", joinedOf(itemsOf(values), [&](const std::string& value) {
                       return tomlOf(value, option);
                     }));
}

/// Returns the table of one axis from "KEY=VALUES".
std::string axisOf(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  const std::string key(trimmed(std::string_view(text).substr(0, std::min(equals, text.size()))));
  if (equals == text.npos || key.empty()) {
    fail(option,
         "not a grid; write \"KEY=VALUES\" or \"KEY=VALUES x KEY=VALUES\", for example "
         "\"initial.tilt=1e-2,1e-4 x simulation.substeps=1..8\"");
  }
  const std::string values(trimmed(std::string_view(text).substr(equals + 1)));
  return fmt::format("{{ key = {}, {} }}", document::tomlString(key), valuesOf(values, option));
}

/// Returns overrides that give a scene the grid of `text`, SceneOptions::grid.
std::vector<Shorthand> gridShorthands(const std::string& text) {
  static const std::regex kBetween(R"(\s+x\s+(?=[^\s=]+\s*=))");
  std::vector<std::string> axes(std::sregex_token_iterator(text.begin(), text.end(), kBetween, -1),
                                {});
  if (axes.size() > 2) fail(text, "a grid has one key or two, columns and rows");
  std::string grid = "columns = " + axisOf(axes.front(), text);
  if (axes.size() > 1) grid += ", rows = " + axisOf(axes.back(), text);
  return {{optionText(text), "grid={ " + grid + " }"}, {optionText(text), "expect={}"}};
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
  for (auto& [key, location] : scene.locations.byKey) {
    for (const auto& [option, assignment] : shorthands)
      if (location == document::overrideLocation(assignment)) location = option;
  }
}

/// Returns whether a text with `overrides` has a single motion, and not the section that
/// `assignment` sets. False, too, for one that can't be read: reading it says why.
bool isUnstated(const std::string& assignment, const std::string& text,
                std::span<const std::string> overrides) {
  try {
    document::TomlNode tree = document::parseToml(text, "");
    document::applyOverrides(tree, overrides);
    const auto& table = std::get<document::TomlNode::Table>(tree.value);
    return std::ranges::none_of(
        std::set<std::string>{assignment.substr(0, assignment.find('=')), "panel", "grid"},
        [&](const std::string& section) { return find(table, section) != nullptr; });
  } catch (const InputError&) {
    return false;
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
  throw InputError(fmt::format("the name {} {}: rename the scene's file{}", quotedText(name),
                               problem,
                               name == scene.name ? "" : ", or shorten the panel's label"));
}

}  // namespace

void SceneOptions::addTo(CLI::App& command, bool draws) {
  constexpr const char* kGroup = "Scene";
  const char* pictures = draws ? kGroup : "";
  repeated(
      addOption(command, "--set", "KEY=VALUE", overrides,
                "Override a key of the scene, e.g. --set simulation.substeps=10; may be repeated"))
      ->group(kGroup);
  addOption(command, "--size", "WxH", size,
            "Picture size, e.g. 640x360; the same as --set clip.size", pictures);
  addOption(command, "--grid", "KEY=VALUES [x KEY=VALUES]", grid,
            "Books side by side, e.g. \"initial.tilt=1e-2,1e-4 x simulation.substeps=1..8\"",
            pictures);
  addAllowOutside(command, allowOutside)->group(pictures);
}

void SceneOptions::refuseSize(const std::string& remedy) const {
  if (size.empty()) return;
  throw InputError("--size " + size + ": the size of clips, which changes nothing here; " + remedy);
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
  addOption(command, "--scene-checksum", "XXH128,...", checksums,
            "Refuse a scene that has changed since 'submit' wrote these checksums", "Scene")
      ->delimiter(',')
      ->allow_extra_args(false);
}

scene::Scene SceneOptions::read(const std::string& path, std::vector<Shorthand> shorthands,
                                const std::optional<Shorthand>& unstated) const {
  if (path != system::kStandardInput) store::requireScene(path);
  const std::string text = store::readSceneText(path);
  if (unstated && grid.empty()) {
    const std::vector<std::string> all = assignments(shorthands);
    if (isUnstated(unstated->assignment, text, all)) shorthands.push_back(*unstated);
  }
  scene::Scene read = applied(std::move(shorthands), [&](std::span<const std::string> all) {
    return store::readScene(path, text, all, allowOutside);
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

std::vector<std::string> SceneOptions::assignments(const std::vector<Shorthand>& after) const {
  std::vector<std::string> all = overrides;
  for (const Shorthand& shorthand : after) all.push_back(shorthand.assignment);
  return all;
}

scene::Scene SceneOptions::applied(std::vector<Shorthand> shorthands, const Reader& reader) const {
  if (!size.empty()) shorthands.push_back({"--size " + size, sizeOverride(size)});
  if (!grid.empty()) {
    for (Shorthand& shorthand : gridShorthands(grid)) shorthands.push_back(std::move(shorthand));
  }
  try {
    scene::Scene read = reader(assignments(shorthands));
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
  throw InputError(system::nameOfInput(path) +
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
      const std::string both =
          owner->second == scene.name
              ? "two scenes are named " + scene.name
              : fmt::format("{} and {} both write {}.csv", owner->second, scene.name, stem);
      throw InputError(both +
                       "; they would overwrite each other: render them into different folders");
    }
  }
}

}  // namespace rotatebook::cli
