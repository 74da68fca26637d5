#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/error_report.h"
#include "cli/exit_code.h"
#include "cli/motion_report.h"
#include "cli/scene_options.h"
#include "cli/scene_report.h"
#include "picture/preflight.h"
#include "scene/scene_text.h"
#include "scene/source_locations.h"
#include "store/scene_file.h"
#include "store/scene_search.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

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
  bool json = false, print = false;
};

int checkScenes(const CheckArguments& arguments) {
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
    std::cout << (arguments.print ? scene::sceneText(*file.scene) : oneLine(path) + ": ok\n");
  }
  if (arguments.json) reportChecksAsJson(files, std::cout);
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

int listScenes(const std::string& folder, bool json) {
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
  json ? reportListAsJson(files, std::cout) : printList(files);
  return statusOfAll(files);
}

}  // namespace

void addCheckCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand("check", "Validate scenes; writes nothing");
  command->add_option("FILE", arguments->paths, "Scene files")->required();
  CLI::Option* json =
      command->add_flag("--json", arguments->json,
                        "Print one JSON object: each file's errors, notes and number of frames");
  command->add_flag("--print", arguments->print, "Print the scenes with every default explicit")
      ->excludes(json);
  arguments->sceneOptions.addTo(*command);
  command->footer(R"(
Examples:
  rotatebook check scenes/*.toml
  rotatebook check scenes/starter.toml --print > full.toml)");
  command->callback(
      [arguments, &action] { action = [arguments] { return checkScenes(*arguments); }; });
}

void addListCommand(CLI::App& program, Action& action) {
  auto folder = std::make_shared<std::string>("scenes");
  CLI::App* command = program.add_subcommand("list", "List the scenes below a folder");
  auto json = std::make_shared<bool>(false);
  command->add_option("DIR", *folder, "Folder")->capture_default_str();
  command->add_flag("--json", *json, "Print one JSON object: each scene's title, length and size");
  command->footer("\nExample:\n  rotatebook list scenes/figures");
  command->callback(
      [folder, json, &action] { action = [folder, json] { return listScenes(*folder, *json); }; });
}

}  // namespace rotatebook::cli
