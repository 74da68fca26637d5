// The commands and options that the parser knows, for texts made of them. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// Lists the commands for users, in the order of the help.
inline std::vector<const CLI::App*> commandsOf(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

/// Lists their names.
inline std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : commandsOf(program)) names.push_back(command->get_name());
  return names;
}

/// Lists the named options of `command` for users, in the order of the help.
inline std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) {
    return !option->get_group().empty() && option->nonpositional();
  });
}

/// Returns how the help calls the value of `option`, such as "WxH"; empty for a flag.
inline std::string valueName(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string name = option.get_type_name();
  const std::size_t range = name.find(" in [");  // "N:INT in [1 - 64]"
  return range == name.npos ? name : name.substr(0, name.rfind(':', range));
}

}  // namespace rotatebook::cli
