#include "cli/usage.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <regex>
#include <system_error>
#include <utility>

#include "base/nearest_name.h"
#include "base/text.h"
#include "video/video_format.h"

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

/// Returns the commands that help shows.
std::vector<const CLI::App*> shownCommands(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : shownCommands(program)) names.push_back(command->get_name());
  return names;
}

/// Returns "--size" and so on; hidden ones, too. One letter is as near to any other.
std::vector<std::string> longOptions(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string_view> viewsOf(const std::vector<std::string>& texts) {
  return {texts.begin(), texts.end()};
}

/// Returns "; `subject` is an option of COMMAND", of the first that has `option`; empty if none
/// has.
std::string ownerText(const CLI::App& program, const std::string& option,
                      const std::string& subject) {
  if (program.get_option_no_throw(option) != nullptr) {
    return "; " + subject + " takes no command: rotatebook " + option;
  }
  for (const CLI::App* command : shownCommands(program)) {
    if (command->get_option_no_throw(option) == nullptr) continue;
    return "; " + subject + " is an option of " + command->get_name();
  }
  return "";
}

/// Returns how the unknown option `name` may have been meant; empty if nothing is near.
std::string optionHint(const CLI::App& program, const std::string& name) {
  const CLI::App& command = chosen(program);
  if (command.get_option_no_throw(name) != nullptr) {
    return "; it comes after the command: rotatebook " + command.get_name() + " ... " + name;
  }
  const std::string elsewhere = ownerText(program, name, "it");
  if (!elsewhere.empty() || name.size() == 2) return elsewhere;
  const std::string wanted = name.starts_with("--") ? name : "-" + name;
  const std::vector<std::string> options = longOptions(command);
  const auto begins = [&](const std::string& option) { return option.starts_with(wanted); };
  if (wanted.size() > 3 && std::ranges::count_if(options, begins) == 1)
    return "; did you mean " + quotedText(*std::ranges::find_if(options, begins)) + "?";
  const std::string own = didYouMean(wanted, viewsOf(options));
  if (!own.empty()) return own;
  std::vector<std::string> others;
  for (const CLI::App* other : shownCommands(program)) {
    std::ranges::move(longOptions(*other), std::back_inserter(others));
  }
  const auto nearest = nearestName(wanted, viewsOf(others));
  return nearest ? ownerText(program, std::string(*nearest), std::string(*nearest)) : "";
}

/// Returns whether `argument`, which begins with a dash, is likely a file: it is there, or ends as
/// the files of this program do.
bool isFile(const std::string& argument) {
  std::error_code ignored;
  if (!argument.starts_with('-') || argument.find('=') != std::string::npos) return false;
  if (fs::is_regular_file(argument, ignored)) return true;
  const std::string ending = fs::path(argument).extension().string();
  return ending == ".toml" || ending == ".png" ||
         std::ranges::any_of(video::kVideoFormats, [&](video::VideoFormat format) {
           return ending == rowOf(format).ending;
         });
}

std::string unknownOptionText(const CLI::App& program, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const CLI::App& command = chosen(program);
  const std::string where = &command == &program ? "" : " of " + command.get_name();
  return "unknown option" + where + ": " + echoed(name) +
         (isFile(word) ? "" : optionHint(program, name));
}

/// Returns what is wrong where `words` are too many: "unexpected argument: b.png; still takes
/// only SCENE".
std::string unexpectedText(const CLI::App& command, const std::vector<std::string>& words) {
  std::vector<std::string> taken;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) taken.push_back(option->get_name(true));
  }
  return "unexpected argument: " + echoed(words.front()) + "; " + command.get_name() + " takes " +
         (taken.empty() ? "only options" : "only " + listed(taken));
}

/// Returns the message of CLI11, in our words where its own are hard to read.
std::string parserText(const CLI::Error& error) {
  static const std::array<std::pair<std::regex, const char*>, 3> kWords{{
      {std::regex("(.*): 1 required (.*) missing"), "$1 needs a value: $2"},
      {std::regex("Could not convert: (.*) = (.*)"), "$1 $2: not a number"},
      {std::regex("^(--[^ ]+) excludes (--[^ ]+)$"), "$1 and $2 exclude each other"},
  }};
  std::string text = echoed(error.what());
  for (const auto& [theirs, ours] : kWords) text = std::regex_replace(text, theirs, ours);
  return text;
}

/// Returns what is wrong with the command line.
std::string wrongPart(const CLI::App& program, const CLI::Error& error) {
  std::vector<std::string> unknown = program.remaining(true);
  std::erase(unknown, "--");
  const auto option =
      std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with('-'); });
  if (option != unknown.end()) return unknownOptionText(program, *option);
  const CLI::App& command = chosen(program);
  if (&command != &program) {
    return unknown.empty() ? parserText(error) : unexpectedText(command, unknown);
  }
  if (!unknown.empty()) return unknownCommandText(program, unknown.front());
  return "a command is needed, for example: rotatebook render scenes/starter.toml";
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
  return text + didYouMean(name, viewsOf(commandNames(program)));
}

std::string problemText(const CLI::App& program, const CLI::Error& error,
                        std::span<char* const> arguments) {
  return wrongPart(program, error) + dashHint(arguments);
}

std::string adviceText(const CLI::App& program) {
  const CLI::App& command = chosen(program);
  const bool none = &command == &program;
  const std::string names = none && program.remaining().empty()
                                ? "Commands: " + joined(commandNames(program)) + '\n'
                                : "";
  return names + "Run 'rotatebook " + (none ? "" : command.get_name() + ' ') +
         "--help' for more information.\n";
}

}  // namespace rotatebook::cli
