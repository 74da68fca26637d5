#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/scene_options.h"
#include "picture/still.h"
#include "store/result_owners.h"

namespace rotatebook::cli {
namespace {

struct StillArguments {
  std::string scene;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::optional<double> time;
  std::string output;
};

int writeStill(const StillArguments& arguments) {
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  const std::string output = arguments.output.empty() ? scene.name + ".png" : arguments.output;
  if (arguments.output.empty()) refuseSameNames({scene});
  refuseInputs(output, inputsOf(arguments.scene, scene));
  requireEnding(output, ".png");
  store::refuseResultsOfOthers({store::ResultKind::Still, scene.name}, {output},
                               "the still would replace it; name another file with -o");
  std::error_code ignored;
  const bool replaces = arguments.output.empty() && std::filesystem::exists(output, ignored);
  const std::int64_t frame =
      picture::renderStill(scene, arguments.time, output, arguments.deviceOptions.choice());
  std::cout << scene.name << ": wrote frame " << frame << " to " << oneLine(output) << '\n';
  if (replaces) {
    std::cerr << "note: " << scene.name << ": replaced " << oneLine(output) << '\n';
  }
  return kDone;
}

}  // namespace

void addStillCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<StillArguments>();
  CLI::App* command = program.add_subcommand("still", "Draw one picture of a scene");
  command->add_option("SCENE", arguments->scene, "Scene file")->required();
  command
      ->add_option("--time", arguments->time,
                   "Time in the video, whose nearest frame is drawn; by default the poster's")
      ->type_name("SECONDS");
  command
      ->add_option("-o,--output", arguments->output,
                   "PNG to write; by default NAME.png, in the folder where you are")
      ->type_name("FILE");
  arguments->sceneOptions.addTo(*command);
  arguments->deviceOptions.addTo(*command);
  command->footer(R"(
Examples:
  rotatebook still scenes/starter.toml
  rotatebook still scenes/starter.toml --time 2.5 -o book.png --size 1920x1080)");
  command->callback(
      [arguments, &action] { action = [arguments] { return writeStill(*arguments); }; });
}

}  // namespace rotatebook::cli
