#include "cli/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <pty.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rotatebook::cli::testing {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollInterval = 5;   // [ms]
constexpr int kCannotStart = 127;  // The shell's status for a program that can't be started.
constexpr int kSignalled = 128;    // The shell's status for a signal, less the signal.

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

// A pipe or pseudo-terminal: the end that the child writes to, and the one that we read.
struct Channel {
  Descriptor read, write;
};

Channel makePipe() {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Channel makeTerminal(unsigned short columns = 0) {
  int master = -1;
  int slave = -1;
  const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
  if (openpty(&master, &slave, nullptr, nullptr, &size) != 0) fail("openpty");
  Channel channel{Descriptor(master), Descriptor(slave)};
  fcntl(master, F_SETFD, FD_CLOEXEC);
  fcntl(slave, F_SETFD, FD_CLOEXEC);
  return channel;
}

Channel openFile(const std::string& path) {
  Channel channel{Descriptor(), Descriptor(open(path.c_str(), O_WRONLY | O_CLOEXEC))};
  if (channel.write.number() < 0) fail(path.c_str());
  return channel;
}

void limit(decltype(RLIMIT_FSIZE) resource, long most) {
  const rlimit limit{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(resource, &limit);
}

// Only what is safe between fork and exec of a process without threads.
[[noreturn]] void becomeProgram(std::vector<char*>& arguments, const ChildSettings& settings,
                                int output, int error) {
  dup2(output, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  for (const int descriptor : settings.closed) close(descriptor);
  // Whoever runs the tests may ignore them, and what is ignored stays so.
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) signal(number, SIG_DFL);
  if (settings.ignoredSignal != 0) signal(settings.ignoredSignal, SIG_IGN);
  for (const auto& [name, value] : settings.environment) setenv(name.c_str(), value.c_str(), 1);
  if (settings.obeysPermissions) {
    prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
    prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH);
  }
  if (settings.largestFile) limit(RLIMIT_FSIZE, *settings.largestFile);
  if (settings.stack) limit(RLIMIT_STACK, *settings.stack);
  if (chdir(settings.folder.c_str()) == 0) execv(arguments.front(), arguments.data());
  _exit(kCannotStart);
}

/// A started program, killed if it is left running.
class Child {
 public:
  Child(const std::filesystem::path& program, std::vector<std::string> words,
        const ChildSettings& settings, int output, int error) {
    words.insert(words.begin(), program.string());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ < 0) fail("fork");
    if (process_ == 0) becomeProgram(arguments, settings, output, error);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    wait();
  }

  void send(int signal) const { kill(process_, signal); }
  int wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
  }

 private:
  pid_t process_ = -1;
};

// Appends what has come to `text`, and closes the channel at its end. A terminal whose other end is
// closed gives an error instead of an end.
void take(Descriptor& descriptor, std::string& text) {
  std::array<char, 65536> block;
  const ssize_t size = read(descriptor.number(), block.data(), block.size());
  if (size > 0) {
    text.append(block.data(), static_cast<std::size_t>(size));
  } else if (size == 0 || errno != EINTR) {
    descriptor.close();
  }
}

bool isTimeForSignal(const ChildSettings& settings, const std::string& error) {
  if (settings.signalWhen) return settings.signalWhen();
  return !settings.signalUpon.empty() && error.find(settings.signalUpon) != error.npos;
}

void readAll(Descriptor& output, Descriptor& error, const Child& child,
             const ChildSettings& settings, ChildResult& result) {
  const Clock::time_point deadline = Clock::now() + settings.timeout;
  bool signalDue = settings.signal != 0;
  while (output.number() >= 0 || error.number() >= 0) {
    std::array<pollfd, 2> watched{{{output.number(), POLLIN, 0}, {error.number(), POLLIN, 0}}};
    poll(watched.data(), watched.size(), kPollInterval);
    if (watched[0].revents != 0) take(output, result.output);
    if (watched[1].revents != 0) take(error, result.error);
    if (signalDue && isTimeForSignal(settings, result.error)) {
      child.send(settings.signal);
      signalDue = false;
    }
    if (Clock::now() > deadline) child.send(SIGKILL);
  }
}

}  // namespace

std::string whyNoTerminal() {
  try {
    makeTerminal();
    return "";
  } catch (const std::system_error& error) {
    return std::string("no terminal can be opened: ") + error.what();
  }
}

ChildResult runChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const ChildSettings& settings) {
  Channel output = settings.outputFile.empty() ? makePipe() : openFile(settings.outputFile);
  Channel error = settings.terminal ? makeTerminal(settings.columns) : makePipe();
  Child child(program, arguments, settings, output.write.number(), error.write.number());
  output.write.close();
  error.write.close();
  ChildResult result;
  readAll(output.read, error.read, child, settings, result);
  result.status = child.wait();
  return result;
}

}  // namespace rotatebook::cli::testing
