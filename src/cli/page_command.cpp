#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "page/page.h"

namespace rotatebook::cli {
namespace {

struct PageArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  std::string folder = "out";
  std::string title = "The unstable rotation of a book";
};

int writePage(const PageArguments& arguments) {
  std::vector<scene::Scene> scenes;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path));
  }
  refuseSameNames(scenes);
  std::vector<page::Figure> figures;
  for (const scene::Scene& scene : scenes) {
    figures.push_back(page::readFigure(scene, arguments.folder));
  }
  const auto path = std::filesystem::path(arguments.folder) / page::kPageName;
  writeFileAtomically(path, page::pageText(arguments.title, figures));
  std::cout << "wrote " << path.string() << ", " << figures.size()
            << (figures.size() == 1 ? " figure\n" : " figures\n");
  return kDone;
}

}  // namespace

void addPageCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<PageArguments>();
  CLI::App* command = program.add_subcommand(
      "page", "Show what was rendered on one page, with players, plots and tables");
  command->add_option("SCENE", arguments->scenes, "Scene files, in the order of the page")
      ->required();
  command
      ->add_option("-o,--output", arguments->folder,
                   "Folder with the results of render and study; the page goes there, too")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--title", arguments->title, "The page's heading")
      ->type_name("TEXT")
      ->capture_default_str();
  arguments->sceneOptions.addTo(*command);
  command->footer(R"(
Writes DIR/index.html, which any browser shows without a network or a server. It shows the files that
render and study left in DIR; --set and --size must be as they were given to these. The motions are
simulated anew for the plots and for what was expected and measured.

Example:
  rotatebook render scenes/figures/*.toml && rotatebook page scenes/figures/*.toml)");
  command->callback(
      [arguments, &action] { action = [arguments] { return writePage(*arguments); }; });
}

}  // namespace rotatebook::cli
