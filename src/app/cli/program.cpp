#include "cli/program.h"

#include <csignal>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/crash_handler.h"
#include "cli/error_report.h"
#include "cli/exit_code.h"
#include "cli/standard_streams.h"

namespace rotatebook::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  rotatebook render scenes/starter.toml
  rotatebook render scenes/figures/*.toml -o out --size 640x360
  rotatebook simulate scenes/starter.toml --csv - | head
  rotatebook study scenes/starter.toml --integrators euler,rk4
  rotatebook COMMAND --help

Exit status: 0 done; 1 an expectation, comparison or proof failed; 2 the input is wrong; 3 the machine
can't do it (no EGL, encoder or gnuplot; a full disk); 129, 130 or 143 interrupted.)";

void addCommands(CLI::App& program, Action& action) {
  addRenderCommand(program, action);
  addSimulateCommand(program, action);
  addStudyCommand(program, action);
  addPageCommand(program, action);
  addStillCommand(program, action);
  addSheetCommand(program, action);
  addBenchCommand(program, action);
  addDoctorCommand(program, action);
  addCheckCommand(program, action);
  addSceneCommand(program, action);
  addListCommand(program, action);
  addAssembleCommand(program, action);
  addVerifyCommand(program, action);
  addRerunCommand(program, action);
  addDiffCommand(program, action);
}

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
    throw InputError("argument " + std::to_string(i) + ", after " + arguments[i - 1] +
                     ", is empty; is it a variable that isn't set?");
  }
}

/// Returns what is wrong with the command line; CLI11 would only report a missing command.
std::string problemText(const CLI::App& program, const CLI::Error& error) {
  if (!program.get_subcommands().empty()) return error.what();
  const std::vector<std::string> unknown = program.remaining();
  if (unknown.empty()) return "a command is needed, for example render";
  return (unknown.front().starts_with('-') ? "unknown option: " : "unknown command: ") +
         unknown.front();
}

std::string usageText(const CLI::App* program, const CLI::Error& error) {
  std::string command = "rotatebook";
  for (const CLI::App* used : program->get_subcommands()) command += ' ' + used->get_name();
  return "rotatebook: " + problemText(*program, error) + "\nRun '" + command +
         " --help' for more information.\n";
}

}  // namespace

int runProgram(int argc, char** argv) {
  keepStandardStreams();
  reportCrashes();
  // Exceeding a limit on the size of files is to be reported as a write error.
  std::signal(SIGXFSZ, SIG_IGN);
  // If the parent process had it ignored, waitpid() couldn't return the status of our children.
  std::signal(SIGCHLD, SIG_DFL);
  return guarded([&] {
    refuseEmptyArguments({argv, static_cast<std::size_t>(argc)});
    CLI::App program(
        "rotatebook renders a spinning book, simulated and checked, to PNG frames and MP4 clips.",
        "rotatebook");
    program.set_version_flag("--version", std::string("rotatebook ") + kVersion);
    program.require_subcommand(1);
    program.footer(kFooter);
    program.failure_message(usageText);
    Action action;
    addCommands(program, action);
    try {
      program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // CLI11 has statuses of its own: zero after --help and --version, else an error.
      return afterFlush(program.exit(error) == 0 ? kDone : kWrongInput);
    }
    return afterFlush(action());
  });
}

}  // namespace rotatebook::cli
