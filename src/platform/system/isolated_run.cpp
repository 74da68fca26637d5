#include "system/isolated_run.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <optional>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/core.h>

#include "base/text.h"
#include "system/child_process.h"
#include "system/crash_signals.h"
#include "system/file_descriptor.h"

namespace rotatebook::system {
namespace {

constexpr off_t kMaxTail = 400;  // [bytes]

void runAsCopy(const std::function<void()>& action, const FileDescriptor& output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  // The crash handlers of this process would report that it crashed.
  for (const int crash : kCrashSignals) std::signal(crash, SIG_DFL);
  dup2(output.number(), STDERR_FILENO);
  // Exceptions aren't reported: they come again where the caller runs the action itself.
  action();
}

std::string causeOf(const ProcessEnd& end) {
  if (end.signal != 0) return strsignal(end.signal);
  return fmt::format("exit status {}", end.status);
}

/// Returns the last line of `output`, as ": LINE", or empty.
std::string lastLine(const FileDescriptor& output) {
  const off_t size = lseek(output.number(), 0, SEEK_END);
  std::array<char, kMaxTail> end;
  const ssize_t read =
      pread(output.number(), end.data(), end.size(), std::max<off_t>(size - kMaxTail, 0));
  const std::string_view text =
      trimmed({end.data(), read > 0 ? static_cast<std::size_t>(read) : 0});
  const std::string line(text.substr(text.rfind('\n') + 1));
  return line.empty() ? "" : ": " + line;
}

}  // namespace

std::string runIsolated(const std::function<void()>& action, std::chrono::seconds timeout) {
  const FileDescriptor output = createMemoryFile("stderr");
  ChildProcess copy = ChildProcess::copy([&] { runAsCopy(action, output); });
  const std::optional<ProcessEnd> end = copy.wait(timeout);
  if (end && end->signal == 0 && end->status == 0) return "";
  return (end ? fmt::format("ends the process ({})", causeOf(*end))
              : fmt::format("doesn't return within {} s", timeout.count())) +
         lastLine(output);
}

}  // namespace rotatebook::system
