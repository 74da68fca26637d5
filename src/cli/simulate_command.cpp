#include <iostream>
#include <memory>
#include <string>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/expectation_report.h"
#include "cli/scene_options.h"
#include "pipeline/simulate_scene.h"
#include "pipeline/trajectory_csv.h"

namespace rotatebook::cli {
namespace {

struct SimulateArguments {
  std::string scene;
  SceneOptions sceneOptions;
  std::string csv;
};

int simulateScene(const SimulateArguments& arguments) {
  const scene::Scene scene = arguments.sceneOptions.read(arguments.scene);
  const pipeline::ClipMotion motion = pipeline::simulateScene(scene);
  const physics::Trajectory& trajectory = motion.trajectories().front();
  const std::string table = pipeline::trajectoryCsv(trajectory);
  if (arguments.csv == "-") {
    std::cout << table;
    return sayIfUnmet(reportMotion(trajectory, scene.expectations, std::cerr));
  }
  writeFileAtomically(arguments.csv, table);
  std::cout << scene.name << ": " << scene.title << "\n  wrote " << arguments.csv << ", "
            << trajectory.samples.size() << " rows\n";
  return sayIfUnmet(reportMotion(trajectory, scene.expectations, std::cout));
}

}  // namespace

void addSimulateCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command =
      program.add_subcommand("simulate", "Simulate a scene without drawing it; needs no graphics");
  command->add_option("SCENE", arguments->scene, "Scene file")->required();
  command
      ->add_option("--csv", arguments->csv,
                   "Table to write, one row a frame; - for the standard output")
      ->type_name("FILE")
      ->required();
  arguments->sceneOptions.addTo(*command);
  command->footer(R"(
Examples:
  rotatebook simulate scenes/starter.toml --csv motion.csv
  rotatebook simulate scenes/starter.toml --csv - --set simulation.model=particles | head)");
  command->callback(
      [arguments, &action] { action = [arguments] { return simulateScene(*arguments); }; });
}

}  // namespace rotatebook::cli
