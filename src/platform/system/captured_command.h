// Programs that are run for what they print.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace rotatebook::system {

/// The output and the end of a program.
struct CapturedCommand {
  int status = 0;        ///< Exit status, or 128 + the signal that ended it.
  std::string output;    ///< Of its standard output.
  std::string problems;  ///< Of its standard error.
};

/// Runs the program that is named first in `command`, found by PATH, without input. Returns nothing
/// if there is no such program. Throws MachineError if it can't be started, or is killed because it
/// takes longer than `timeout`, which another try may help.
std::optional<CapturedCommand> capture(const std::vector<std::string>& command,
                                       std::chrono::seconds timeout);

}  // namespace rotatebook::system
