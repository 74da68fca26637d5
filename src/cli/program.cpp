#include "cli/program.h"

#include <exception>
#include <iostream>
#include <new>

#include "base/error.h"
#include "base/version.h"
#include "cli/commands.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  rotatebook render scenes/starter.toml
  rotatebook render scenes/figures/*.toml -o out --size 640x360
  rotatebook simulate scenes/starter.toml --csv - | head
  rotatebook COMMAND --help

Exit status: 0 done; 1 an expectation or comparison failed; 2 the input is wrong; 3 the machine can't
(no EGL, no encoder, disk); 130 or 143 interrupted.)";

void addCommands(CLI::App& program, Action& action) {
  addRenderCommand(program, action);
  addSimulateCommand(program, action);
  addStillCommand(program, action);
  addCheckCommand(program, action);
  addSceneCommand(program, action);
  addListCommand(program, action);
  addAssembleCommand(program, action);
  addDiffCommand(program, action);
}

int fail(const char* message, int status) {
  std::cerr << "rotatebook: " << message << '\n';
  return status;
}

int runAction(const Action& action) {
  try {
    const int status = action();
    std::cout.flush();
    return std::cout ? status : fail("can't write to the standard output", kMachineFailed);
  } catch (const Error& error) {
    return fail(error.what(), error.kind() == ErrorKind::Input ? kWrongInput : kMachineFailed);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", kMachineFailed);
  } catch (const std::exception& error) {
    return fail(error.what(), kMachineFailed);
  }
}

}  // namespace

int runProgram(int argc, char** argv) {
  CLI::App program(
      "rotatebook renders a spinning book, simulated and checked, to PNG frames and MP4 clips.",
      "rotatebook");
  program.set_version_flag("--version", std::string("rotatebook ") + kVersion);
  program.require_subcommand(1);
  program.footer(kFooter);
  Action action;
  addCommands(program, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11 has its own statuses; ours says that the input is wrong. Help and version are not
    // errors.
    return program.exit(error) == 0 ? kDone : kWrongInput;
  }
  return runAction(action);
}

}  // namespace rotatebook::cli
