// Processes that this one starts and waits for. Inside the room only.
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

/// The end of a process.
struct ProcessEnd {
  int status = 0;  ///< Exit status, 0 to 255.
  int signal = 0;  ///< Signal that ended it, instead of a status; 0 if none did.
};

/// The standard streams of a process to be started.
struct StandardStreams {
  const FileDescriptor& input;
  const FileDescriptor& output;
  const FileDescriptor& error;
};

/// A process that was started. The destructor kills one that nobody has waited for.
class ChildProcess {
 public:
  /// Starts the program that is named first in `command`, found by PATH, with the others as its
  /// arguments; returns nothing if there is no such program. Throws MachineError.
  static std::optional<ChildProcess> start(std::vector<std::string> command,
                                           const StandardStreams& streams);
  /// Runs `action` in a copy of this process (fork), which has the calling thread alone and exits
  /// without cleaning up when `action` returns or throws. Throws MachineError.
  static ChildProcess copy(const std::function<void()>& action);

  ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  ChildProcess& operator=(ChildProcess&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~ChildProcess();

  /// Waits for the process to end; to be called once. Throws MachineError.
  ProcessEnd wait();
  /// Like wait(), but after `timeout` kills the process and returns nothing.
  std::optional<ProcessEnd> wait(std::chrono::seconds timeout);

 private:
  explicit ChildProcess(pid_t id) : id_(id) {}
  /// Returns the end, if the process has ended or `options` (of waitpid) wait for that.
  std::optional<ProcessEnd> end(int options);

  pid_t id_;  // 0: nothing to wait for.
};

}  // namespace rotatebook::system
