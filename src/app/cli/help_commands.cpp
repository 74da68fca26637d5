#include <iostream>
#include <memory>
#include <string>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/usage.h"

namespace rotatebook::cli {
namespace {

std::string helpOf(const CLI::App& program, const std::string& name) {
  const std::string own = program.get_name();
  // help() of the program would be that of the chosen command, this one.
  if (name.empty()) {
    return program.get_formatter()->make_help(&program, own, CLI::AppFormatMode::Normal);
  }
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() == name) return command->help(own);
  }
  throw InputError(unknownCommandText(program, name));
}

}  // namespace

void addHelpCommand(CLI::App& program, Action& action) {
  auto name = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("help", "Describe the program, or one command");
  command->add_option("COMMAND", *name, "Command to describe");
  command->footer("\nExample:\n  rotatebook help render");
  command->callback([name, &program, &action] {
    action = [name, &program] {
      std::cout << helpOf(program, *name);
      return kDone;
    };
  });
}

}  // namespace rotatebook::cli
