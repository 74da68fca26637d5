#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/scene_options.h"
#include "picture/still.h"

namespace rotatebook::cli {
namespace {

struct StillArguments {
  std::string scene;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  double time = 0;
  std::string output;
};

int writeStill(const StillArguments& arguments) {
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  refuseInputs(arguments.output, inputsOf(arguments.scene, scene));
  const std::int64_t frame = picture::renderStill(scene, arguments.time, arguments.output,
                                                  arguments.deviceOptions.choice());
  std::cout << scene.name << ": wrote frame " << frame << " to " << arguments.output << '\n';
  return kDone;
}

}  // namespace

void addStillCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<StillArguments>();
  CLI::App* command = program.add_subcommand("still", "Draw one picture of a scene");
  command->add_option("SCENE", arguments->scene, "Scene file")->required();
  command->add_option("--time", arguments->time, "Time in the clip; the nearest frame is drawn")
      ->type_name("SECONDS")
      ->required();
  command->add_option("-o,--output", arguments->output, "PNG to write")
      ->type_name("FILE")
      ->required();
  arguments->sceneOptions.addTo(*command);
  arguments->deviceOptions.addTo(*command);
  command->footer(R"(
Example:
  rotatebook still scenes/starter.toml --time 2.5 -o book.png --size 1920x1080)");
  command->callback(
      [arguments, &action] { action = [arguments] { return writeStill(*arguments); }; });
}

}  // namespace rotatebook::cli
