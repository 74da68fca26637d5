#include "cli/manual_page.h"

#include <fmt/core.h>

#include "base/version.h"
#include "cli/command_tree.h"

namespace rotatebook::cli {
namespace {

/// Returns `text` so that man prints it as it is, its hyphens as those of a command line.
std::string escaped(const std::string& text) {
  std::string result;
  bool begins = true;
  for (const char letter : text) {
    if (begins && (letter == '.' || letter == '\'')) result += "\\&";
    begins = letter == '\n';
    if (letter == '\\') {
      result += "\\e";
    } else {
      result += letter == '-' ? "\\-" : std::string(1, letter);
    }
  }
  return result;
}

std::string optionText(const CLI::Option& option) {
  std::string names = escaped(option.get_name(false, true));
  names = CLI::detail::find_and_replace(names, ",", "\\fR, \\fB");
  std::string value = escaped(valueName(option));
  if (!value.empty()) value = " \\fI" + value + "\\fR";
  const std::string initial = option.get_default_str();
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}{}\n", names, value, escaped(option.get_description()),
                     initial.empty() ? "" : escaped(fmt::format(" (default: {})", initial)));
}

/// Returns the footer of a help, whose lines are broken already.
std::string footerText(const CLI::App& app) {
  const std::string text = app.get_footer();
  if (text.empty()) return "";
  return fmt::format(".PP\n.nf\n{}\n.fi\n", escaped(text.substr(text.find_first_not_of('\n'))));
}

std::string commandText(const CLI::App& program, const CLI::App& command) {
  const CLI::Formatter formatter;
  std::string usage;
  std::string options;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || option->get_group().empty()) continue;
    usage += ' ' + formatter.make_option_usage(option);
    options += fmt::format(".TP\n\\fI{}\\fR\n{}\n", escaped(option->get_name(true, false)),
                           escaped(option->get_description()));
  }
  for (const CLI::Option* option : optionsOf(command)) {
    // An option of every command is the program's, too, and is described there.
    if (program.get_option_no_throw(option->get_name()) == nullptr) options += optionText(*option);
  }
  return fmt::format(".SS {0}\n{1}.\n.PP\n\\fB{2} {0}\\fR [OPTIONS]{3}\n{4}{5}",
                     escaped(command.get_name()), escaped(command.get_description()),
                     program.get_name(), escaped(usage), options, footerText(command));
}

}  // namespace

std::string manualPage(const CLI::App& program) {
  std::string text = fmt::format(
      ".TH ROTATEBOOK 1 \"\" \"rotatebook {}\" \"User Commands\"\n"
      ".SH NAME\nrotatebook \\- simulate and render a tumbling book\n"
      ".SH SYNOPSIS\n.B rotatebook\nCOMMAND [OPTIONS]\n"
      ".SH DESCRIPTION\n{}\n.SH OPTIONS\nEach command has \\-\\-help and \\-\\-quiet, too.\n",
      kVersion, escaped(program.get_description()));
  for (const CLI::Option* option : optionsOf(program)) text += optionText(*option);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : commandsOf(program)) text += commandText(program, *command);
  return text + ".SH EXAMPLES AND EXIT STATUS\n" + footerText(program).substr(4);
}

}  // namespace rotatebook::cli
