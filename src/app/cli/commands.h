// Commands: functions that add them, one each, and what all need to describe their options to the
// parser. Inside the room only.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// The work of the chosen command. Returns the exit status; throws Error.
using Action = std::function<int()>;

/// Describes a command and its options to the parser; sets `action` if the command is chosen.
using AddCommand = void(CLI::App& program, Action& action);

#define ROTATEBOOK_COMMAND(add) AddCommand add;
#include "cli/command_list.inc"
#undef ROTATEBOOK_COMMAND

/// The value of --output that is the standard output, of `still` and `render`.
inline constexpr const char* kStandardOutput = "-";

/// The name of a command that isn't for users: a process that crashes while it draws becomes it.
inline constexpr const char* kAfterCrash = "after-crash";
inline constexpr const char* kStack = "--stack";  ///< Its option: the file with the other's stack.
inline constexpr const char* kResumable = "--resumable";  ///< Its flag: the other had --resume.

/// A command, and the arguments that its options set.
template <typename Arguments>
struct Command {
  CLI::App& app;
  Arguments& arguments;
};

/// Adds a command that is `work` with its arguments.
template <typename Arguments>
Command<Arguments> addCommand(CLI::App& program, Action& action, const char* name,
                              const char* description, int (*work)(const Arguments&)) {
  CLI::App* app = program.add_subcommand(name, description);
  auto arguments = std::make_shared<Arguments>();
  app->callback([=, &action] { action = [=] { return work(*arguments); }; });
  return {*app, *arguments};
}

/// Adds an option, whose value the help calls `type`, below the heading `group`.
template <typename Value>
CLI::Option* addOption(CLI::App& command, const char* names, const char* type, Value& value,
                       const std::string& description, const char* group = "Options") {
  return command.add_option(names, value, description)->type_name(type)->group(group);
}

/// Has `option` take one value each time that it is given, and keep all.
inline CLI::Option* repeated(CLI::Option* option) {
  return option->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

}  // namespace rotatebook::cli
