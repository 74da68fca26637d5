#include "system/captured_command.h"

#include <fmt/core.h>

#include "base/error.h"
#include "system/child_process.h"
#include "system/file_descriptor.h"

namespace rotatebook::system {

std::optional<CapturedCommand> capture(const std::vector<std::string>& command,
                                       std::chrono::seconds timeout) {
  const FileDescriptor input = createMemoryFile("input"), output = createMemoryFile("output"),
                       problems = createMemoryFile("problems");
  auto child = ChildProcess::start(command, {input, output, problems});
  if (!child) return std::nullopt;
  const auto end = child->wait(timeout);
  if (!end) {
    throw MachineError(
        fmt::format("{} doesn't answer within {} s", command.front(), timeout.count()),
        ErrorKind::Transient);
  }
  return CapturedCommand{end->signal == 0 ? end->status : 128 + end->signal,
                         readAll(output, command.front()), readAll(problems, command.front())};
}

}  // namespace rotatebook::system
