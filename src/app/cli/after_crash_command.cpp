#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/crash_handler.h"
#include "cli/device_options.h"
#include "cli/error_report.h"
#include "cli/exit_code.h"
#include "diagnose/checkup.h"

namespace rotatebook::cli {
namespace {

struct CrashArguments {
  DeviceOptions deviceOptions;
  bool resumable = false;
  int signal = SIGABRT;
};

/// Reports the driver that crashed. If none did, ends as the process that crashed would have.
int explain(const CrashArguments& arguments) {
  if (arguments.resumable) adviseResume();
  try {
    if (const auto problem = diagnose::explainCrash(arguments.deviceOptions.parsed())) {
      std::cerr << "rotatebook: can't draw: " << problem->what << "\n  remedy: " << problem->remedy
                << crashAdvice();
      return kMachineFailed;
    }
  } catch (...) {
    reportError(std::current_exception(), "the drivers can't be tried: ");
  }
  return raise(arguments.signal);  // Reported by the handler of crashes.
}

}  // namespace

void addAfterCrashCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<CrashArguments>();
  CLI::App* command = program.add_subcommand(kAfterCrash, "Explain the crash of a command");
  command->group("");  // Hidden.
  arguments->deviceOptions.addTo(*command);
  command->add_flag(kResumable, arguments->resumable);
  command->add_option("SIGNAL", arguments->signal)->required();
  command->callback([arguments, &action] { action = [arguments] { return explain(*arguments); }; });
}

}  // namespace rotatebook::cli
