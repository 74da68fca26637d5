#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "base/document/toml_text.h"
#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/motion_report.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "embedded/cli.h"
#include "picture/preflight.h"
#include "scene/scene_schema.h"
#include "scene/scene_text.h"
#include "store/scene_file.h"
#include "store/scene_name.h"
#include "store/scene_search.h"
#include "system/atomic_file.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

/// A scene file that was read.
struct SceneFile {
  fs::path path;
  std::optional<scene::Scene> scene{};  ///< Nothing if it can't be read.
  /// Of its clip, which ends early if its motion diverges; nothing if it wasn't simulated.
  std::optional<std::int64_t> frames{};
  std::vector<std::string> notes{};   ///< On what is likely a slip in it.
  std::vector<std::string> errors{};  ///< Why the scene isn't usable; empty if it is.
};

/// Reads a file by `read`; reports and keeps the message if it is wrong.
template <typename Read>
SceneFile readFile(const fs::path& path, const Read& read) {
  SceneFile file{path};
  try {
    file.scene = read(path);
  } catch (const InputError& error) {
    printError(error.what());
    file.errors.emplace_back(error.what());
  }
  return file;
}

int statusOfAll(const std::vector<SceneFile>& files) {
  const bool ok =
      std::ranges::all_of(files, [](const SceneFile& file) { return file.errors.empty(); });
  return ok ? kDone : kWrongInput;
}

struct CheckArguments {
  std::vector<std::string> paths;
  SceneOptions sceneOptions;
  bool json = false, print = false, schema = false;
};

Json fileObject(const SceneFile& file) {
  Json object;
  object["path"] = file.path.string();
  object["ok"] = file.errors.empty();
  object["errors"] = file.errors;
  return object;
}

Json labelsJson(const scene::Scene& scene) {
  if (!scene.hasPanels()) return Json::array();
  return arrayOf(scene.motions, [](const scene::Panel& panel) { return panel.label; });
}

Json checkJson(const SceneFile& file) {
  Json object = fileObject(file);
  object["notes"] = file.notes;
  if (!file.scene) return object;
  if (file.frames) object["frames"] = *file.frames;
  object["panels"] = labelsJson(*file.scene);
  return object;
}

Json listJson(const SceneFile& file) {
  Json object = fileObject(file);
  if (!file.scene) return object;
  const scene::Scene& scene = *file.scene;
  object["name"] = scene.name;
  object["title"] = scene.title;
  object["duration_s"] = scene.clip.duration;
  object["width"] = scene.clip.width;
  object["height"] = scene.clip.height;
  object["frames"] = scene.clip.frameCount();
  object["panels"] = labelsJson(scene);
  object["has_study"] = scene.study.has_value();
  return object;
}

void printJson(const std::vector<SceneFile>& files, Json (*asJson)(const SceneFile&)) {
  std::cout << jsonText({{"scenes", arrayOf(files, asJson)}}) << '\n';
}

int checkScenes(const CheckArguments& arguments) {
  if (arguments.schema) {
    std::cout << scene::sceneSchema();
    return kDone;
  }
  if (arguments.paths.empty()) throw InputError("name the scenes to check");
  std::vector<std::string> notes;  // on the file that is read
  const auto check = [&](const fs::path& path) {
    const scene::Scene scene = arguments.sceneOptions.read(path);
    refuseSameNames({scene});
    picture::preflight(scene);
    notes = picture::notesOn(scene);
    reportNotes(scene, notes, std::cerr);
    return scene;
  };
  std::vector<SceneFile> files;
  for (const std::string& path : arguments.paths) {
    files.push_back(readFile(path, check));
    SceneFile& file = files.back();
    if (!file.errors.empty()) continue;
    file.notes = notes;
    if (arguments.json) file.frames = timeline::simulateScene(*file.scene).frameCount();
    if (arguments.json) continue;
    const std::string name = system::nameOfInput(path);
    std::cout << (arguments.print ? scene::sceneText(*file.scene) : oneLine(name) + ": ok\n");
  }
  if (arguments.json) printJson(files, checkJson);
  return statusOfAll(files);
}

void printList(const std::vector<SceneFile>& files) {
  std::size_t width = 0;
  for (const SceneFile& file : files) width = std::max(width, file.path.string().size());
  for (const SceneFile& file : files) {
    if (!file.scene) continue;
    std::cout << std::left << std::setw(static_cast<int>(width)) << oneLine(file.path.string())
              << "  " << std::right << std::setw(4) << shortestText(file.scene->clip.duration)
              << " s  " << file.scene->title << '\n';
  }
}

struct ListArguments {
  std::string folder = "scenes";
  bool json = false;
};

int listScenes(const ListArguments& arguments) {
  const std::string& folder = arguments.folder;
  const auto [paths, problems] = store::scenesBelow(folder);
  if (paths.empty() && problems.empty()) throw InputError(folder + " holds no scenes (*.toml)");
  std::vector<SceneFile> files;
  for (const auto& [path, message] : problems) {
    printError(message);
    files.push_back({.path = path, .errors = {message}});
  }
  for (const fs::path& path : paths) {
    files.push_back(readFile(path, [](const fs::path& file) { return store::readScene(file); }));
  }
  arguments.json ? printJson(files, listJson) : printList(files);
  return statusOfAll(files);
}

}  // namespace

void addCheckCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "check", "Validate scenes; writes nothing", checkScenes);
  CLI::Option* files = command.add_option("FILE", arguments.paths, "Scene files");
  command
      .add_flag("--schema", arguments.schema,
                "Print the JSON Schema of scenes, for editors, in place of FILE")
      ->excludes(files);
  CLI::Option* json =
      command.add_flag("--json", arguments.json,
                       "Print one JSON object: each file's errors, notes and number of frames");
  command.add_flag("--print", arguments.print, "Print the scenes with every default explicit")
      ->excludes(json);
  arguments.sceneOptions.addTo(command);
  command.footer(R"(
Examples:
  rotatebook check scenes/*.toml
  rotatebook check scenes/starter.toml --print > full.toml
  rotatebook check --schema > scene.schema.json)");
}

void addListCommand(CLI::App& program, Action& action) {
  auto [command, arguments] =
      addCommand(program, action, "list", "List the scenes below a folder", listScenes);
  command.add_option("DIR", arguments.folder, "Folder")
      ->capture_default_str()
      ->check(notStandardInput);
  command.add_flag("--json", arguments.json,
                   "Print one JSON object: each scene's title, length and size");
  command.footer("\nExample:\n  rotatebook list scenes/figures");
}

namespace {

/// Returns the title of a scene named `name`: "my-first_throw" is "My first throw".
std::string titleFrom(std::string name) {
  std::ranges::replace(name, '-', ' ');
  std::ranges::replace(name, '_', ' ');
  if (name.front() >= 'a' && name.front() <= 'z') name.front() -= 'a' - 'A';
  return name;
}

/// Returns the text of scenes/starter.toml with another title.
std::string starterWith(const std::string& title) {
  constexpr std::string_view kTitle = "title = ";
  std::string text(starterScene());
  const std::size_t begin = text.find(kTitle) + kTitle.size();
  text.replace(begin, text.find('\n', begin) - begin, document::tomlString(title));
  return text;
}

/// Throws InputError if no scene can be written to `path`.
void requireNew(const fs::path& path) {
  if (path.extension() != ".toml") {
    throw InputError(fmt::format("{}: the name of a scene's file ends in .toml, as {}.toml does",
                                 path.string(), path.stem().string()));
  }
  const std::string name = path.stem().string();
  if (const std::string problem = store::problemOfName(name); !problem.empty()) {
    throw InputError(fmt::format("{}: the scene's name {} {}; choose another", path.string(),
                                 quotedText(name), problem));
  }
  std::error_code ignored;
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    throw InputError(fmt::format("{}: there is no folder {}; make it, or choose another",
                                 path.string(), folder.string()));
  }
  requireAbsent(path);
}

int writeNewScene(const std::string& file) {
  const fs::path path(file);
  requireNew(path);
  const std::string text = starterWith(titleFrom(path.stem().string()));
  scene::parseScene(text, path);  // A title may be too long.
  system::writeFileAtomically(path, text);
  std::cout << fmt::format(
      "wrote {}\nnext: change a number in it, and run\n  rotatebook render {}\n",
      oneLine(path.string()), oneLine(shellWord(path.string())));
  return kDone;
}

}  // namespace

void addNewCommand(CLI::App& program, Action& action) {
  auto [command, file] =
      addCommand(program, action, "new", "Write a commented scene to begin with", writeNewScene);
  command.add_option("FILE", file, "Scene file to write, NAME.toml")
      ->required()
      ->check(notStandardOutput);
  command.footer("\nAn existing file is never overwritten.\n\nExample:\n  rotatebook new my.toml");
}

}  // namespace rotatebook::cli
