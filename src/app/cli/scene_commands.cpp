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
#include "cli/exit_code.h"
#include "cli/motion_report.h"
#include "cli/scene_options.h"
#include "picture/preflight.h"
#include "scene/scene_text.h"
#include "store/scene_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

int checkScenes(const std::vector<std::string>& paths, const SceneOptions& options) {
  int status = kDone;
  for (const std::string& path : paths) {
    try {
      const scene::Scene scene = options.read(path);
      refuseSameNames({scene});
      picture::preflight(scene);
      printNotes(scene);
      std::cout << oneLine(path) << ": ok\n";
    } catch (const InputError& error) {
      std::cerr << "rotatebook: " << error.what() << '\n';
      status = kWrongInput;
    }
  }
  return status;
}

std::vector<fs::path> scenesBelow(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  }
  if (error)
    throw InputError("can't list the scenes in " + folder.string() + ": " + error.message() +
                     "; name a folder that holds scenes: rotatebook list DIR");
  if (paths.empty()) throw InputError(folder.string() + " holds no scenes (*.toml)");
  std::sort(paths.begin(), paths.end());
  return paths;
}

int listScenes(const std::string& folder) {
  const std::vector<fs::path> paths = scenesBelow(folder);
  std::size_t width = 0;
  for (const fs::path& path : paths) width = std::max(width, path.string().size());
  int status = kDone;
  for (const fs::path& path : paths) {
    try {
      const scene::Scene scene = store::readScene(path);
      std::cout << std::left << std::setw(static_cast<int>(width)) << oneLine(path.string()) << "  "
                << std::right << std::setw(4) << shortestText(scene.clip.duration) << " s  "
                << scene.title << '\n';
    } catch (const InputError& error) {
      std::cerr << "rotatebook: " << error.what() << '\n';
      status = kWrongInput;
    }
  }
  return status;
}

}  // namespace

void addCheckCommand(CLI::App& program, Action& action) {
  auto paths = std::make_shared<std::vector<std::string>>();
  auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand("check", "Validate scenes; writes nothing");
  command->add_option("FILE", *paths, "Scene files")->required();
  options->addTo(*command);
  command->footer("\nExample:\n  rotatebook check scenes/*.toml");
  command->callback([paths, options, &action] {
    action = [paths, options] { return checkScenes(*paths, *options); };
  });
}

void addSceneCommand(CLI::App& program, Action& action) {
  auto path = std::make_shared<std::string>();
  auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand("scene", "Show a scene with every default explicit");
  command->add_option("--print", *path, "Scene file")->type_name("FILE")->required();
  options->addTo(*command);
  command->footer("\nExample:\n  rotatebook scene --print scenes/starter.toml > full.toml");
  command->callback([path, options, &action] {
    action = [path, options] {
      std::cout << scene::sceneText(options->read(*path));
      return kDone;
    };
  });
}

void addListCommand(CLI::App& program, Action& action) {
  auto folder = std::make_shared<std::string>("scenes");
  CLI::App* command = program.add_subcommand("list", "List the scenes below a folder");
  command->add_option("DIR", *folder, "Folder")->capture_default_str();
  command->footer("\nExample:\n  rotatebook list scenes/figures");
  command->callback([folder, &action] { action = [folder] { return listScenes(*folder); }; });
}

}  // namespace rotatebook::cli
