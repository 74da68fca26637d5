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

#include "base/text.h"
#include "system/child_process.h"
#include "system/crash_signals.h"
#include "system/file_descriptor.h"

namespace rotatebook::system {
namespace {

constexpr off_t kLongestWords = 400;  // [bytes]

void runAsCopy(const std::function<void()>& action, const FileDescriptor& words) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  // What handles crashes here would say that this process crashed.
  for (const int crash : kCrashSignals) std::signal(crash, SIG_DFL);
  dup2(words.number(), STDERR_FILENO);
  // What it throws is reported to whoever runs it in earnest.
  action();
}

std::string causeOf(const ProcessEnd& end) {
  if (end.signal != 0) return strsignal(end.signal);
  return "exit status " + std::to_string(end.status);
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

std::string runIsolated(const std::function<void()>& action, std::chrono::seconds longest) {
  const FileDescriptor words = createMemoryFile("words");
  ChildProcess copy = ChildProcess::copy([&] { runAsCopy(action, words); });
  const std::optional<ProcessEnd> end = copy.wait(longest);
  if (end && end->signal == 0 && end->status == 0) return "";
  return (end ? "ends the process (" + causeOf(*end) + ")"
              : "doesn't come back within " + std::to_string(longest.count()) + " s") +
         lastLine(words);
}

}  // namespace rotatebook::system
