#include "system/child_process.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::system {
namespace {

constexpr std::chrono::milliseconds kPollInterval{5};

/// The redirections that a new process makes before its program begins.
class SpawnActions {
 public:
  explicit SpawnActions(const StandardStreams& streams) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, streams.input.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, streams.output.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, streams.error.number(), STDERR_FILENO);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

std::optional<ChildProcess> ChildProcess::start(std::vector<std::string> command,
                                                const StandardStreams& streams) {
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t id = 0;
  const int error = posix_spawnp(&id, arguments.front(), SpawnActions(streams).get(), nullptr,
                                 arguments.data(), environ);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) {
    throw MachineError(fmt::format("can't start {}: {}", command.front(), std::strerror(error)));
  }
  return ChildProcess(id);
}

ChildProcess ChildProcess::copy(const std::function<void()>& action) {
  const pid_t id = fork();
  if (id < 0) throw MachineError(std::string("can't start a process: ") + std::strerror(errno));
  if (id > 0) return ChildProcess(id);
  try {
    action();
  } catch (...) {
    // Unwinding further would run the caller's code twice.
  }
  _exit(0);
}

ChildProcess::~ChildProcess() {
  if (id_ == 0) return;
  kill(id_, SIGKILL);
  while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<ProcessEnd> ChildProcess::end(int options) {
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(id_, &status, options);
  } while (ended < 0 && errno == EINTR);
  if (ended < 0) throw MachineError("can't wait for another process");
  if (ended == 0) return std::nullopt;
  id_ = 0;
  if (WIFSIGNALED(status)) return ProcessEnd{.signal = WTERMSIG(status)};
  return ProcessEnd{.status = WEXITSTATUS(status)};
}

ProcessEnd ChildProcess::wait() {
  return *end(0);
}

std::optional<ProcessEnd> ChildProcess::wait(std::chrono::seconds timeout) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  for (;;) {
    if (const auto ended = end(WNOHANG)) return ended;
    if (std::chrono::steady_clock::now() > deadline) break;
    std::this_thread::sleep_for(kPollInterval);
  }
  kill(id_, SIGKILL);
  end(0);
  return std::nullopt;
}

}  // namespace rotatebook::system
