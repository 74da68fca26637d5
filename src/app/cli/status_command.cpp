#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "farm/farm_report.h"
#include "farm/status.h"

namespace rotatebook::cli {

void addStatusCommand(CLI::App& program, Action& action) {
  auto folder = std::make_shared<std::string>("out");
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("status", "Show what has become of what was submitted");
  command->add_option("DIR", *folder, "Folder of the results")->capture_default_str();
  command->add_flag("--json", *json, "Print one JSON object: scenes, tasks and jobs");
  command->footer(R"(
Shows what is done, which machine runs what, what failed, and about when it ends: from the results
in DIR, what 'rotatebook submit' left in DIR/farm, and Slurm's queue. Changes nothing.
Exit status: 0, or 1 if something failed.

Example:
  rotatebook status out)");
  command->callback([folder, json, &action] {
    action = [folder, json] {
      const std::vector<farm::PlanState> states = farm::statesBelow(*folder);
      *json ? farm::reportStatesAsJson(states, std::cout) : farm::reportStates(states, std::cout);
      return statusOf(std::ranges::none_of(states, &farm::PlanState::hasFailed));
    };
  });
}

}  // namespace rotatebook::cli
