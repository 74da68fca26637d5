#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/scene_options.h"
#include "image/png_file.h"
#include "picture/sheet.h"
#include "store/clip_files.h"

namespace rotatebook::cli {
namespace {

struct SheetArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  picture::SheetOptions options;
  bool noCaption = false;
  std::string output;
};

int writeSheet(const SheetArguments& arguments) {
  std::vector<scene::Scene> scenes;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path));
    refuseInputs(arguments.output, inputsOf(path, scenes.back()));
    if (!arguments.noCaption) continue;
    std::erase_if(scenes.back().overlay.show, [](scene::Overlay overlay) {
      return overlay == scene::Overlay::Caption || overlay == scene::Overlay::Settings;
    });
  }
  requireEnding(arguments.output, ".png");
  picture::SheetOptions options = arguments.options;
  options.device = arguments.deviceOptions.choice();
  const image::Image sheet = picture::drawSheet(scenes, options);
  const bool transparent = std::ranges::any_of(scenes, &scene::isTransparent);
  image::writePng(arguments.output, sheet.view(), transparent);
  std::cout << "wrote " << oneLine(arguments.output) << ", "
            << sizeText(sheet.width(), sheet.height()) << '\n';
  return kDone;
}

}  // namespace

void addSheetCommand(CLI::App& program, Action& action) {
  constexpr int kMax = 1000;
  auto arguments = std::make_shared<SheetArguments>();
  picture::SheetOptions& options = arguments->options;
  CLI::App* command =
      program.add_subcommand("sheet", "Draw frames of scenes side by side on one picture");
  command->add_option("SCENE", arguments->scenes, "Scene files")->required();
  command->add_option("-o,--output", arguments->output, "PNG to write")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--count", options.count,
                   "Frames of each scene, from its first to its last; 1 draws its poster")
      ->type_name("N")
      ->check(CLI::Range(1, kMax))
      ->capture_default_str();
  command
      ->add_option("--times", options.times, "Times of the frames in the clip, in place of --count")
      ->type_name("SECONDS,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes("--count");
  command->add_option("--columns", options.columns, "Pictures in a row")
      ->type_name("N")
      ->check(CLI::Range(1, kMax));
  command->add_flag("--no-caption", arguments->noCaption, "Leave the caption out of the pictures");
  arguments->sceneOptions.addTo(*command);
  arguments->deviceOptions.addTo(*command);
  command->footer(R"(
--size is the size of each picture. Beneath each is what tells it apart: its time, its scene's
title, or both.

Examples:
  rotatebook sheet scenes/starter.toml -o sheet.png --size 480x270
  rotatebook sheet scenes/starter.toml -o sheet.png --times 0,0.5,1 --columns 3
  rotatebook sheet scenes/figures/*.toml -o sheet.png --count 1 --size 480x270)");
  command->callback(
      [arguments, &action] { action = [arguments] { return writeSheet(*arguments); }; });
}

}  // namespace rotatebook::cli
