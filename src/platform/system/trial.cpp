#include "system/trial.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <optional>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "base/error.h"
#include "base/text.h"
#include "system/crash_signals.h"
#include "system/file_descriptor.h"

namespace rotatebook::system {
namespace {

constexpr std::chrono::milliseconds kPollInterval{5};
constexpr off_t kLongestWords = 400;  // [bytes]

[[noreturn]] void runAsCopy(const std::function<void()>& action, const FileDescriptor& words) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  // What handles crashes here would say that this process crashed.
  for (const int crash : kCrashSignals) std::signal(crash, SIG_DFL);
  dup2(words.number(), STDERR_FILENO);
  try {
    action();
  } catch (const std::exception&) {
    // Whoever runs it in earnest is told.
  }
  _exit(0);
}

/// Its status, or none if it had to be killed.
std::optional<int> wait(pid_t copy, std::chrono::seconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(copy, &status, WNOHANG);
    if (ended == copy) return status;
    if (ended < 0 && errno != EINTR) throw MachineError("can't wait for another process");
    if (std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(kPollInterval);
  }
  kill(copy, SIGKILL);
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) continue;
  return {};
}

std::string causeOf(int status) {
  if (WIFSIGNALED(status)) return strsignal(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

/// The last line of what it wrote, as ": LINE", or empty.
std::string lastLine(const FileDescriptor& words) {
  const off_t size = lseek(words.number(), 0, SEEK_END);
  std::array<char, kLongestWords> end;
  const ssize_t read =
      pread(words.number(), end.data(), end.size(), std::max<off_t>(size - kLongestWords, 0));
  const std::string_view text =
      trimmed({end.data(), read > 0 ? static_cast<std::size_t>(read) : 0});
  const std::string line(text.substr(text.rfind('\n') + 1));
  return line.empty() ? "" : ": " + line;
}

}  // namespace

std::string endOfTrial(const std::function<void()>& action, std::chrono::seconds longest) {
  const FileDescriptor words = createMemoryFile("words");
  const pid_t copy = fork();
  if (copy < 0) throw MachineError(std::string("can't start a process: ") + std::strerror(errno));
  if (copy == 0) runAsCopy(action, words);
  const std::optional<int> status = wait(copy, longest);
  if (status == 0) return "";
  return (status ? "ends the process (" + causeOf(*status) + ")"
                 : "doesn't come back within " + std::to_string(longest.count()) + " s") +
         lastLine(words);
}

}  // namespace rotatebook::system
