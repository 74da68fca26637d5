#include "cli/usage.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include <fmt/core.h>

#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/command_tree.h"
#include "cli/option_checks.h"
#include "scene/key_rows.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestEcho = 200;  // [letters]

std::string echoed(std::string_view argument) {
  return oneLine(argument, kLongestEcho);
}

/// Returns the command that was chosen, or the program itself.
const CLI::App& chosen(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

/// Returns "size" and so on; one letter is as near to any other.
std::vector<std::string_view> longOptions(const CLI::App& command) {
  std::vector<std::string_view> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.emplace_back(name);
  return names;
}

std::string nearestOf(const std::string& name, const std::vector<std::string>& names) {
  return didYouMean(name, std::vector<std::string_view>(names.begin(), names.end()));
}

/// Returns the key of a scene's motion or picture that is called so; empty if there is none.
std::string keyNamed(std::string word) {
  std::ranges::replace(word, '-', '_');
  for (const std::string_view section : {"clip.", "simulation.", "look.", "camera.", "overlay.",
                                         "video.", "body.", "book.", "initial."}) {
    const std::string name = std::string(section) + word;
    if (std::ranges::count(scene::allKeys(), name, &scene::KeyRow::name) > 0) return name;
  }
  return "";
}

/// Returns the commands that have an option, "render and simulate"; empty if none does.
std::string commandsWith(const CLI::App& program, const std::string& option) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (!command->get_group().empty() && command->get_option_no_throw(option) != nullptr)
      names.push_back(command->get_name());
  }
  return names.empty() ? "" : listed(names);
}

/// Returns how the unknown option `name` may have been meant; empty if nothing is near.
std::string optionHint(const CLI::App& program, const std::string& name) {
  const CLI::App& command = chosen(program);
  const std::string word = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  if (command.get_option_no_throw(name) != nullptr)
    return "; it comes after the command: rotatebook " + command.get_name() + " ... " + name;
  const bool isNamed = command.get_option_no_throw("--" + word) != nullptr;
  const bool haveScenes = command.get_option_no_throw("--set") != nullptr;
  const std::string key = isNamed || !haveScenes ? "" : keyNamed(word);
  if (!key.empty()) return fmt::format("; it is a key of scenes: --set {}=...", key);
  if (const std::string others = commandsWith(program, name); !others.empty())
    return "; it is an option of " + others;
  if (name.size() == 2) return "";
  // The dashes are no letters that they have in common.
  const auto nearest = nearestName(word, longOptions(command));
  return nearest ? fmt::format("; did you mean {}?", quotedText("--" + std::string(*nearest))) : "";
}

/// Returns whether an argument that begins with a dash is likely a file.
bool isFile(std::string_view argument) {
  if (!argument.starts_with('-') || argument.find('=') != argument.npos) return false;
  const std::string ending = fs::path(argument).extension().string();
  return ending.size() > 1 && std::isalpha(static_cast<unsigned char>(ending[1]));
}

/// Returns the option of `command` that was given a word that isn't of its type; null for none.
const CLI::Option* misgiven(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    try {
      if (option->count() > 0) option->run_callback();
    } catch (const CLI::ConversionError&) {
      return option;
    }
  }
  return nullptr;
}

/// Returns the parser's words for an option that was given no value, or a wrong one, as ours.
std::string asOurs(const CLI::App& command, const std::string& words) {
  const std::size_t end = words.find(": ");
  if (end == words.npos) return words;
  const std::string name = words.substr(0, end), problem = words.substr(end + 2);
  if (problem.starts_with(kMust)) return name + ' ' + problem;
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr || !problem.ends_with(" missing")) return words;
  const std::string type = option->get_type_name();
  return fmt::format("{0} needs a value: {0} {1}", name, type.substr(0, type.find(':')));
}

/// Returns what is wrong with an option's value.
std::string valueProblem(CLI::App& command, const CLI::Error& error) {
  const bool isOfType = dynamic_cast<const CLI::ConversionError*>(&error) == nullptr;
  const CLI::Option* option = isOfType ? nullptr : misgiven(command);
  if (option == nullptr) return echoed(asOurs(command, error.what()));
  const std::string name = option->get_name(), value = joined(option->results(), ",");
  const bool areSeveral = value.find(',') != value.npos && command.get_option_no_throw(name + "s");
  return name + " must be a number, not " + quotedText(echoed(value)) +
         (areSeveral ? fmt::format("; {}s takes several", name) : "");
}

/// Returns what is wrong with the command line.
std::string wrongPart(const CLI::App& program, const CLI::Error& error) {
  const CLI::App& command = chosen(program);
  const bool isChosen = &command != &program;
  std::vector<std::string> unknown = program.remaining(true);
  std::erase(unknown, "--");
  const auto option =
      std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with('-'); });
  if (option != unknown.end()) {
    const std::string name = option->substr(0, option->find('='));
    return fmt::format("unknown option{}: {}{}", isChosen ? " of " + command.get_name() : "",
                       echoed(name), isFile(*option) ? "" : optionHint(program, name));
  }
  if (!isChosen && unknown.empty())
    return "a command is needed, for example: rotatebook render scenes/starter.toml";
  if (!isChosen) return unknownCommandText(program, unknown.front());
  return unknown.empty() ? valueProblem(*program.get_subcommands().front(), error)
                         : "unexpected argument: " + echoed(unknown.front());
}

/// Returns the remedy where a file was taken for an option; else nothing.
std::string dashHint(std::span<char* const> arguments) {
  const auto file = std::ranges::find_if(arguments, isFile);
  if (file == arguments.end()) return "";
  return "; a file whose name begins with a dash is written ./" + echoed(*file);
}

}  // namespace

std::string unknownCommandText(const CLI::App& program, std::string_view name) {
  const std::string text = "unknown command: " + echoed(name);
  if (name.ends_with(".toml")) {
    return text + "; it is a scene: rotatebook render " + echoed(name);
  }
  return text + nearestOf(std::string(name), commandNames(program));
}

std::string problemText(const CLI::App& program, const CLI::Error& error,
                        std::span<char* const> arguments) {
  return wrongPart(program, error) + dashHint(arguments);
}

std::string adviceText(const CLI::App& program) {
  const CLI::App& command = chosen(program);
  const bool none = &command == &program;
  const std::string names = none && program.remaining().empty()
                                ? fmt::format("Commands: {}\n", joined(commandNames(program)))
                                : "";
  return fmt::format("{}Run 'rotatebook {}--help' for more information.\n", names,
                     none ? "" : command.get_name() + ' ');
}

}  // namespace rotatebook::cli
