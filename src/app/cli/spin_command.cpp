#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "report/spin_report.h"

namespace rotatebook::cli {

void addSpinCommand(CLI::App& program, Action& action) {
  auto path = std::make_shared<std::string>();
  auto options = std::make_shared<SceneOptions>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("spin", "Print the numbers of a scene's spin");
  command->add_option("SCENE", *path, "Scene file")->required();
  command->add_flag("--json", *json, "Print one JSON object");
  options->addTo(*command, /*draws=*/false);
  command->footer(R"(
Principal moments, growth rate, flip interval, period, precession with its geometric part, distance
to the separatrix, and the step that explicit Euler needs.

Examples:
  rotatebook spin scenes/starter.toml
  rotatebook spin scenes/starter.toml --set initial.tilt="['5 deg', 'y']" --json)");
  command->callback([path, options, json, &action] {
    action = [path, options, json] {
      const scene::Scene scene = options->read(*path);
      (*json ? report::reportSpinsAsJson : report::reportSpins)(scene, report::spinNumbersOf(scene),
                                                                std::cout);
      return kDone;
    };
  });
}

}  // namespace rotatebook::cli
