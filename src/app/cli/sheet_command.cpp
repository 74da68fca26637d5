#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/scene_options.h"
#include "image/png_file.h"
#include "picture/sheet.h"
#include "store/result_owners.h"

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

void leaveOutCaption(scene::Scene& scene) {
  std::erase_if(scene.overlay.show, [](scene::Overlay overlay) {
    return overlay == scene::Overlay::Caption || overlay == scene::Overlay::Settings;
  });
}

/// Returns the file to write: the one that was named, or else NAME.sheet.png or, of several scenes,
/// sheet.png.
std::string outputOf(const SheetArguments& arguments, const std::vector<scene::Scene>& scenes) {
  if (!arguments.output.empty()) return arguments.output;
  if (scenes.size() > 1) return "sheet.png";
  refuseSameNames(scenes);
  return scenes.front().name + ".sheet.png";
}

int writeSheet(const SheetArguments& arguments) {
  std::vector<scene::Scene> scenes;
  std::vector<Input> inputs;
  for (const std::string& path : arguments.scenes) {
    scenes.push_back(arguments.sceneOptions.read(path));
    std::ranges::move(inputsOf(path, scenes.back()), std::back_inserter(inputs));
    if (arguments.noCaption) leaveOutCaption(scenes.back());
  }
  const std::string output = outputOf(arguments, scenes);
  refuseInputs(output, inputs);
  requireEnding(output, ".png");
  store::refuseResultsOfOthers({store::ResultKind::Still, scenes.front().name}, {output},
                               "the sheet would replace it; name another file with -o");
  std::error_code ignored;
  const bool replaces = arguments.output.empty() && std::filesystem::exists(output, ignored);
  picture::SheetOptions options = arguments.options;
  options.device = arguments.deviceOptions.choice();
  const image::Image sheet = picture::drawSheet(scenes, options);
  const bool transparent = std::ranges::any_of(scenes, &scene::isTransparent);
  image::writePng(output, sheet.view(), transparent);
  std::cout << "wrote " << oneLine(output) << ", " << sizeText(sheet.width(), sheet.height())
            << '\n';
  if (replaces) std::cerr << "note: replaced " << oneLine(output) << '\n';
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
  command
      ->add_option("-o,--output", arguments->output,
                   "PNG to write; by default NAME.sheet.png, in the folder where you are")
      ->type_name("FILE");
  command
      ->add_option("--count", options.count,
                   "Frames of each scene, from its first to its last; 1 draws its poster")
      ->type_name("N")
      ->check(CLI::Range(1, kMax))
      ->capture_default_str();
  command
      ->add_option("--times", options.times,
                   "Times of the frames in the video, in place of --count")
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
title, or both. The time is that of the video, as --times and 'still --time' take it; where the
motion's is another, in slow motion, that follows as t. Of several scenes, the picture is sheet.png.

Examples:
  rotatebook sheet scenes/starter.toml --size 480x270
  rotatebook sheet scenes/starter.toml -o sheet.png --times 0,0.5,1 --columns 3
  rotatebook sheet scenes/figures/*.toml -o sheet.png --count 1 --size 480x270)");
  command->callback(
      [arguments, &action] { action = [arguments] { return writeSheet(*arguments); }; });
}

}  // namespace rotatebook::cli
