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
#include "cli/scene_options.h"
#include "cli/scene_search.h"
#include "picture/preflight.h"
#include "report/motion_report.h"
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
      report::reportNotes(scene, std::cerr);
      std::cout << oneLine(path) << ": ok\n";
    } catch (const InputError& error) {
      printError(error.what());
      status = kWrongInput;
    }
  }
  return status;
}

int listScenes(const std::string& folder) {
  const auto [paths, problems] = scenesBelow(folder);
  for (const std::string& problem : problems) printError(problem);
  if (paths.empty() && problems.empty()) throw InputError(folder + " holds no scenes (*.toml)");
  std::size_t width = 0;
  for (const fs::path& path : paths) width = std::max(width, path.string().size());
  int status = problems.empty() ? kDone : kWrongInput;
  for (const fs::path& path : paths) {
    try {
      const scene::Scene scene = store::readScene(path);
      std::cout << std::left << std::setw(static_cast<int>(width)) << oneLine(path.string()) << "  "
                << std::right << std::setw(4) << shortestText(scene.clip.duration) << " s  "
                << scene.title << '\n';
    } catch (const InputError& error) {
      printError(error.what());
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
  command->add_option("FILE", *path, "Scene file")->required();
  command->add_flag("--print")->group("");  // Needless; scripts of earlier versions have it.
  options->addTo(*command);
  command->footer("\nExample:\n  rotatebook scene scenes/starter.toml > full.toml");
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
