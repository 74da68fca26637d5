#include "cli/program.h"

#include <csignal>
#include <fcntl.h>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/crash_handler.h"
#include "cli/exit_code.h"
#include "cli/manual_page.h"
#include "cli/option_checks.h"
#include "cli/progress_line.h"
#include "cli/terminal.h"
#include "cli/usage.h"
#include "system/portable_folder.h"
#include "system/resource_limits.h"

namespace rotatebook::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  rotatebook render scenes/starter.toml
  rotatebook render scenes/figures/*.toml -o out --size 640x360
  rotatebook simulate scenes/starter.toml --csv - | head
  rotatebook study scenes/starter.toml --integrators euler,rk4
  rotatebook help render

Exit status: 0 done; 1 an expectation, comparison or proof failed; 2 the input is wrong; 3 the machine
can't do it (no EGL or encoder; a full disk); 4 a clip is too coarse to be proved; 129, 130 or
143 interrupted; 75, in place of 3 or these, if --retry-status asks for it and trying again may help.)";

constexpr std::initializer_list<AddCommand*> kCommands{
#define ROTATEBOOK_COMMAND(add) add,
#include "cli/command_list.inc"
#undef ROTATEBOOK_COMMAND
};

/// Returns `status`; throws MachineError if what was printed got lost.
int afterFlush(int status) {
  std::cout.flush();
  if (std::cout) return status;
  throw MachineError("can't write to the standard output");
}

/// Throws InputError for an empty argument, which no command has a use for.
void refuseEmptyArguments(std::span<char* const> arguments) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (*arguments[i] != '\0') continue;
    throw InputError(fmt::format(
        "argument {}, after {}, is empty; is it a variable that isn't set?", i, arguments[i - 1]));
  }
}

/// Prints help with one empty line between groups, where CLI11 puts two; with whole paragraphs for
/// a terminal, which wraps them.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(bool isForTerminal) : isForTerminal_(isForTerminal) {}

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    const std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
    const std::string text = CLI::detail::find_and_replace(help, "\n\n\n", "\n\n");
    return isForTerminal_ ? withWholeParagraphs(text) : text;
  }

 private:
  bool isForTerminal_;
};

/// Has the checks of `option`, which takes one value, look at its last one alone: that one counts.
void checkLastAlone(CLI::Option& option) {
  try {
    for (int i = 0;; ++i) option.get_validator(i)->application_index(0);
  } catch (const CLI::OptionNotFound&) {
    return;  // There is no other way to learn how many checks it has.
  }
}

/// The options that all commands have.
struct CommonArguments {
  bool quiet = false;
  std::string progress;
};

/// Adds to each command what all have in common, at the end of its help.
void addCommonOptions(CLI::App& program, CommonArguments& arguments) {
  constexpr const char* kGroup = "Every command";
  for (CLI::App* command : program.get_subcommands({})) {
    command->set_help_flag();
    command->set_help_flag("-h,--help", "Print this help and exit")->group(kGroup);
    command->add_flag("-q,--quiet", arguments.quiet, "Print only results, and what is wrong")
        ->group(kGroup);
    addOption(*command, "--progress", "bar|json|none", arguments.progress,
              "How progress is shown on the standard error: as a bar, or plain lines where there "
              "is no terminal; as lines of JSON; not at all",
              kGroup)
        ->check(oneOf({"bar", "json", "none"}));
    const bool printsPictures = command->get_name() == "still" || command->get_name() == "render";
    for (const char* name : {"--output", "--pack", "--junit", "--again"}) {
      CLI::Option* output = command->get_option_no_throw(name);
      if (output != nullptr && !printsPictures) output->check(notStandardOutput);
    }
    for (CLI::Option* option : command->get_options()) {
      if (option->get_expected_max() == 1) checkLastAlone(*option);
    }
  }
}

/// Returns whether `command` was asked for text on the standard output that programs read.
bool printsForPrograms(const CLI::App& command) {
  for (const char* one : {"--json", "--plan", "--dry-run", "--print", "--schema"}) {
    const CLI::Option* option = command.get_option_no_throw(one);
    if (option != nullptr && option->count() > 0) return true;
  }
  for (const char* one : {"--csv", "--output"}) {
    const CLI::Option* option = command.get_option_no_throw(one);
    if (option != nullptr && option->count() > 0 && option->results().back() == "-") return true;
  }
  return false;
}

/// Returns whether `command` was asked for something on the standard output, not for a report.
bool printsResult(const CLI::App& command) {
  const std::string& name = command.get_name();
  for (const char* one : {"info", "judge", "toss", "help", "status"}) {
    if (name == one) return name != "judge" || command.count("--pack") == 0;
  }
  return printsForPrograms(command);
}

/// Holds back what is printed to std::clog and, unless it is the command's result, to std::cout.
class HeldReports {
 public:
  explicit HeldReports(bool outputIsResult) : log_(std::clog.rdbuf(held_.rdbuf())) {
    if (!outputIsResult) output_ = std::cout.rdbuf(held_.rdbuf());
  }
  HeldReports(const HeldReports&) = delete;
  HeldReports& operator=(const HeldReports&) = delete;
  /// Prints to the standard error what was held, as the reason of a failure is in it.
  ~HeldReports() {
    std::clog.rdbuf(log_);
    if (output_ != nullptr) std::cout.rdbuf(output_);
    std::cerr << held_.str();
  }

  /// Forgets what was held.
  void discard() { held_.str({}); }

 private:
  std::ostringstream held_;
  std::streambuf* log_;
  std::streambuf* output_ = nullptr;
};

/// Does the work of `command` without printing its reports; returns the status.
int runQuietly(const CLI::App& command, const Action& action) {
  HeldReports held(printsResult(command));
  const int status = action();
  // The reason of another status may be in the report alone, as that of an unmet expectation is.
  if (status == kDone || status == kWrongInput) held.discard();
  return status;
}

ProgressStyle progressStyleOf(const CommonArguments& arguments) {
  if (arguments.progress == "json") return ProgressStyle::Json;
  const bool isNone =
      arguments.progress == "none" || (arguments.progress.empty() && arguments.quiet);
  return isNone ? ProgressStyle::None : ProgressStyle::Bar;
}

/// Reads the command line and does what it asks for; returns the status. `output` is the standard
/// output's.
int run(int argc, char** argv, TerminalText& output) {
  CLI::App program(
      "rotatebook renders a spinning book, simulated and checked, to PNG frames and MP4 clips.",
      "rotatebook");
  CommonArguments common;
  Action action;
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.set_version_flag("-v,-V,--version", std::string("rotatebook ") + kVersion,
                           "Print the version and exit");
  program.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  program.formatter(std::make_shared<HelpFormatter>(output.isTerminal()));
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.group("Commands");
  program.require_subcommand(1);
  program.footer(kFooter);
  for (AddCommand* add : kCommands) add(program, action);
  addCommonOptions(program, common);
  program.add_flag("-q,--quiet", common.quiet, "Print only results, and what is wrong");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    program.exit(help);
    return kDone;
  } catch (const CLI::ParseError& error) {
    printError(problemText(program, error, {argv, static_cast<std::size_t>(argc)}));
    std::cerr << adviceText(program);
    return kWrongInput;
  }
  const CLI::App& command = *program.get_subcommands().front();
  setProgressStyle(progressStyleOf(common));
  if (printsForPrograms(command)) output.leave();
  return common.quiet ? runQuietly(command, action) : action();
}

/// Opens each standard stream that the program was started without, as one that can't be read or
/// written. Else the next file that is opened would take its descriptor, and what is printed would
/// go into that file.
void keepStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // open() returns the lowest free descriptor, which is this one. The mode makes printing fail,
    // so that the failure is reported.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return;
  }
}

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

int runProgram(int argc, char** argv) {
  keepStandardStreams();
  reportCrashes();
  // Exceeding a limit on the size of files is to be reported as a write error.
  std::signal(SIGXFSZ, SIG_IGN);
  // If the parent process had it ignored, waitpid() couldn't return the status of our children.
  std::signal(SIGCHLD, SIG_DFL);
  std::cout << std::unitbuf;  // What is printed is there at once, in a pipe, too.
  TerminalText output(std::cout, STDOUT_FILENO), error(std::cerr, STDERR_FILENO),
      log(std::clog, STDERR_FILENO);
  return endStatus(guarded([&] {
    system::usePortableFolder();
    system::requireStack();
    refuseEmptyArguments({argv, static_cast<std::size_t>(argc)});
    return afterFlush(run(argc, argv, output));
  }));
}

void addHelpCommand(CLI::App& program, Action& action) {
  struct Arguments {
    std::string name, shell;
    bool manual = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("help", "Describe the program, or one command");
  CLI::Option* named = command->add_option("COMMAND", arguments->name, "Command to describe");
  command->add_flag("--man", arguments->manual, "Print the manual page, for man -l -")
      ->excludes(named);
  addOption(*command, "--completion", "bash|zsh|fish", arguments->shell,
            "Print what has bash, zsh or fish complete command lines")
      ->excludes(named)
      ->excludes("--man");
  command->footer(R"(
'make install' and the Debian package install both: man rotatebook.

Examples:
  rotatebook help render
  source <(rotatebook help --completion bash))");
  command->callback([arguments, &program, &action] {
    action = [arguments, &program] {
      const auto& [name, shell, isManual] = *arguments;
      std::cout << (isManual         ? manualPage(program)
                    : !shell.empty() ? completionScript(program, shell)
                                     : helpOf(program, name));
      return kDone;
    };
  });
}

}  // namespace rotatebook::cli
