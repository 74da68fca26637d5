// Processes that this one starts and waits for.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

#include "system/file_descriptor.h"

namespace rotatebook::system {

/// How a process ended.
struct ProcessEnd {
  int status = 0;  ///< What it exited with, 0 to 255.
  int signal = 0;  ///< The signal that ended it, in place of a status; 0 if none did.
};

/// The standard streams of a process to be started.
struct StandardStreams {
  const FileDescriptor& input;
  const FileDescriptor& output;
  const FileDescriptor& error;
};

/// A process that was started. One that nobody has waited for is killed.
class ChildProcess {
 public:
  /// Starts the program that is named first in `command`, found by PATH, with the other words as
  /// its arguments; none if there is no such program. Throws MachineError.
  static std::optional<ChildProcess> start(std::vector<std::string> command,
                                           const StandardStreams& streams);
  /// Runs `action` in a copy of this process, which ends without cleaning up when that returns. The
  /// copy has this thread alone. Throws MachineError.
  static ChildProcess copy(const std::function<void()>& action);

  ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  ChildProcess& operator=(ChildProcess&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~ChildProcess();

  /// Waits for its end. Once. Throws MachineError.
  ProcessEnd wait();
  /// The same for so long at most; then it is killed, and nothing is returned.
  std::optional<ProcessEnd> wait(std::chrono::seconds longest);

 private:
  explicit ChildProcess(pid_t id) : id_(id) {}
  /// Its end, if it has ended or `options` (of waitpid) wait for that.
  std::optional<ProcessEnd> end(int options);

  pid_t id_;  // 0: nothing to wait for.
};

}  // namespace rotatebook::system
