#include "cli/completion.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/command_tree.h"

namespace rotatebook::cli {
namespace {

/// Returns a description up to its first semicolon, with a backslash before each of `letters`; in
/// single quotes no shell needs more than `'` as it is written there, `quote`.
std::string summary(const std::string& description, std::string_view letters,
                    const std::string& quote) {
  std::string result;
  for (const char letter : description.substr(0, description.find(';'))) {
    if (letters.find(letter) != letters.npos) result += '\\';
    result += letter == '\'' ? quote : std::string(1, letter);
  }
  return result;
}

std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : commandsOf(program)) names.push_back(command->get_name());
  return names;
}

/// Returns the names of an option with their dashes.
std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : optionsOf(command))
    for (const std::string& name : namesOf(*option)) names.push_back(name);
  return joined(names, " ");
}

/// Returns whether the words of `command` are names of commands, not files.
bool namesCommands(const CLI::App& command) {
  return command.get_option_no_throw("COMMAND") != nullptr;
}

std::string bashScript(const CLI::App& program) {
  const std::string names = joined(commandNames(program), " ");
  std::string cases = fmt::format("    \"\") words='{} {}' ;;\n", names, optionNames(program));
  for (const CLI::App* command : commandsOf(program)) {
    cases += fmt::format("    {}) options='{}'{} ;;\n", command->get_name(), optionNames(*command),
                         namesCommands(*command) ? " words='" + names + "'" : "");
  }
  return R"(_rotatebook() {
  local word=${COMP_WORDS[COMP_CWORD]} command="" words="" options="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
  done
  case $command in
)" + cases +
         R"(  esac
  [[ $word != -* || -z $command ]] || words=$options
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o bashdefault -o default -F _rotatebook rotatebook
)";
}

/// Returns the words by which _arguments of zsh knows the options of `command`, and files.
std::string zshArguments(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : optionsOf(command)) {
    const std::string value = valueName(*option);
    for (const std::string& name : namesOf(*option)) {
      text += fmt::format(" \\\n      '*{}[{}]{}'", name,
                          summary(option->get_description(), "[]:\\", "'\\''"),
                          value.empty() ? "" : ": :_files");
    }
  }
  return text + (namesCommands(command) ? " \\\n      '*: :($names)'" : " \\\n      '*: :_files'");
}

std::string zshScript(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : commandsOf(program)) {
    commands += fmt::format("    '{}:{}'\n", command->get_name(),
                            summary(command->get_description(), ":\\", "'\\''"));
    cases += fmt::format("    {}) _arguments{} ;;\n", command->get_name(), zshArguments(*command));
  }
  // The names of commands are expanded where an argument is one.
  cases = CLI::detail::find_and_replace(cases, "$names", joined(commandNames(program), " "));
  return "#compdef rotatebook\n_rotatebook() {\n  local -a commands=(\n" + commands +
         "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n"
         "    compadd -- " +
         optionNames(program) +
         "\n    return\n  fi\n  shift words\n  ((CURRENT--))\n  case $words[1] in\n" + cases +
         "  esac\n}\n"
         "if [[ $funcstack[1] == _rotatebook ]]; then _rotatebook; else compdef _rotatebook "
         "rotatebook; fi\n";
}

/// Returns fish's line for an option that is completed where `condition` holds.
std::string fishOption(const CLI::Option& option, const std::string& condition) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += " -s " + name;
  for (const std::string& name : option.get_lnames()) names += " -l " + name;
  return fmt::format("complete -c rotatebook -n '{}'{}{} -d '{}'\n", condition, names,
                     valueName(option).empty() ? "" : " -r",
                     summary(option.get_description(), "\\", "\\'"));
}

std::string fishScript(const CLI::App& program) {
  const std::string kNone = "__fish_use_subcommand";
  std::string text;
  for (const CLI::Option* option : optionsOf(program)) text += fishOption(*option, kNone);
  for (const CLI::App* command : commandsOf(program)) {
    const std::string chosen = "__fish_seen_subcommand_from " + command->get_name();
    text += fmt::format("complete -c rotatebook -n '{}' -f -a {} -d '{}'\n", kNone,
                        command->get_name(), summary(command->get_description(), "\\", "\\'"));
    for (const CLI::Option* option : optionsOf(*command)) text += fishOption(*option, chosen);
    if (namesCommands(*command)) {
      text += fmt::format("complete -c rotatebook -n '{}' -f -a '{}'\n", chosen,
                          joined(commandNames(program), " "));
    }
  }
  return text;
}

}  // namespace

std::string completionScript(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bashScript(program);
  if (shell == "zsh") return zshScript(program);
  if (shell == "fish") return fishScript(program);
  throw InputError("--completion must be bash, zsh or fish, not " + quotedText(shell));
}

}  // namespace rotatebook::cli
