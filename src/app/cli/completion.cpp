#include "cli/completion.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/command_tree.h"
#include "farm/plan.h"
#include "video/video_format.h"

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

/// Returns the words, with blanks between them, that the first argument of `command` may be: names
/// of commands, or of work; empty if it is a file.
std::string firstWords(const CLI::App& program, const CLI::App& command) {
  if (command.get_option_no_throw("COMMAND") != nullptr) return joined(commandNames(program), " ");
  if (command.get_option_no_throw("WORK") == nullptr) return "";
  std::vector<std::string> works;
  for (const farm::Work work : {farm::Work::Render, farm::Work::Map, farm::Work::Study})
    works.emplace_back(nameOf(work));
  return joined(works, " ");
}

/// Returns whether the arguments of `command` are scene files, after its work if it has one.
bool takesScenes(const CLI::App& command) {
  return command.get_option_no_throw("SCENE") != nullptr;
}

/// Returns the values among those that a help calls "bar|json|none" or "english|german|FILE", with
/// blanks between them: a word with capitals stands for others.
std::string literalsOf(const std::string& type) {
  if (type.find('|') == type.npos) return "";
  std::vector<std::string> literals;
  for (const std::string& word : CLI::detail::split(type, '|'))
    if (std::ranges::none_of(word, [](char letter) { return letter >= 'A' && letter <= 'Z'; }))
      literals.push_back(word);
  return joined(literals, " ");
}

/// Returns the values, with blanks between them, that an option may have, as the parser checks
/// them, the help names them or another list of the program does; empty for others.
std::string choicesOf(const CLI::Option& option) {
  if (option.check_lname("format")) {
    std::vector<std::string> formats;
    for (const video::FormatRow& row : video::kFormatRows) formats.emplace_back(row.name);
    return joined(formats, " ");
  }
  return literalsOf(option.get_type_name());
}

/// Returns whether an option's value may be a file beside its choices.
bool takesFiles(const CLI::Option& option) {
  return option.get_type_name().ends_with("|FILE");
}

/// Returns a line of a shell's `case` for each option of `command` that has a value: choices, or
/// none, which leaves files.
std::string valueCases(const CLI::App& command) {
  std::string cases;
  for (const CLI::Option* option : optionsOf(command)) {
    if (valueName(*option).empty()) continue;
    for (const std::string& name : namesOf(*option))
      cases += fmt::format("    {}:{}) words='{}' scenes='' ;;\n", command.get_name(), name,
                           choicesOf(*option));
  }
  return cases;
}

std::string bashScript(const CLI::App& program) {
  const std::string names = joined(commandNames(program), " ");
  std::string cases = fmt::format("    \"\") words='{} {}' ;;\n", names, optionNames(program));
  std::string values;
  for (const CLI::App* command : commandsOf(program)) {
    const std::string words = firstWords(program, *command);
    cases += fmt::format("    {}) options='{}'{}{} ;;\n", command->get_name(),
                         optionNames(*command), words.empty() ? "" : " words='" + words + "'",
                         takesScenes(*command) ? " scenes='*.toml'" : "");
    values += valueCases(*command);
  }
  return R"(_rotatebook() {
  local word=${COMP_WORDS[COMP_CWORD]} command="" words="" options="" scenes="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
  done
  case $command in
)" + cases +
         R"(  esac
  for ((++i; i < COMP_CWORD; ++i)); do
    [[ " $words " != *" ${COMP_WORDS[i]} "* ]] || words=""
  done
  [[ $word != -* || -z $command ]] || words=$options
  case $command:${COMP_WORDS[COMP_CWORD - 1]} in
)" + values +
         R"(  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  [[ -z $words && -n $scenes ]] || return 0
  mapfile -t COMPREPLY < <(compgen -f -X "!$scenes" -- "$word"; compgen -d -- "$word")
  compopt -o filenames 2> /dev/null || true
}
complete -o bashdefault -o default -F _rotatebook rotatebook
)";
}

/// Returns the words by which _arguments of zsh knows the options of `command`, and files.
std::string zshArguments(const CLI::App& program, const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : optionsOf(command)) {
    const std::string value = valueName(*option), choices = choicesOf(*option);
    for (const std::string& name : namesOf(*option)) {
      text += fmt::format(" \\\n      '*{}[{}]{}'", name,
                          summary(option->get_description(), "[]:\\", "'\\''"),
                          value.empty()         ? ""
                          : choices.empty()     ? ": :_files"
                          : takesFiles(*option) ? ": :{compadd " + choices + "; _files}"
                                                : ": :(" + choices + ")");
    }
  }
  const std::string words = firstWords(program, command);
  if (!words.empty()) text += fmt::format(" \\\n      '1: :({})'", words);
  return text + " \\\n      '*: :_files" + (takesScenes(command) ? " -g \"*.toml\"'" : "'");
}

std::string zshScript(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : commandsOf(program)) {
    commands += fmt::format("    '{}:{}'\n", command->get_name(),
                            summary(command->get_description(), ":\\", "'\\''"));
    cases += fmt::format("    {}) _arguments{} ;;\n", command->get_name(),
                         zshArguments(program, *command));
  }
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
  const std::string choices = choicesOf(option);
  return fmt::format(
      "complete -c rotatebook -n '{}'{}{}{} -d '{}'\n", condition, names,
      valueName(option).empty() ? "" : " -r",
      choices.empty() ? "" : (takesFiles(option) ? " -a '" : " -f -a '") + choices + "'",
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
    const std::string words = firstWords(program, *command);
    if (!words.empty())
      text += fmt::format("complete -c rotatebook -n '{}' -a '{}'\n", chosen, words);
    if (takesScenes(*command))
      text += fmt::format("complete -c rotatebook -n '{}' -k -a '(__fish_complete_suffix .toml)'\n",
                          chosen);
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
