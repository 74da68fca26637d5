#include "cli/crash_handler.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <execinfo.h>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

#include "cli/exit_code.h"
#include "system/crash_signals.h"
#include "system/crash_successor.h"

namespace rotatebook::cli {
namespace {

constexpr std::string_view kCrash =
    "rotatebook: crashed, in its own code or in a driver; 'rotatebook doctor' tries each driver";
constexpr std::string_view kResume =
    ".\nWhat the render had finished is kept: go on with the same command and --resume\n";
constexpr std::string_view kOutOfMemory = "rotatebook: out of memory";

std::atomic<bool> mayResume = false;

// Calls only functions that are safe in a signal handler.
void printCrash(std::string_view problem) {
  for (const std::string_view text : {problem, crashAdvice()}) {
    // A failure can't be reported anywhere.
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
  }
}

/// In memory; kept open for the process that takes the place of this one.
std::atomic<int> stackFile = -1;

/// Writes this thread's stack, but not over that of a process before this one. Safe in a handler,
/// as `backtrace` has been called before.
void keepStack() {
  if (lseek(stackFile, 0, SEEK_END) != 0) return;
  std::array<void*, 40> frames{};
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  backtrace_symbols_fd(frames.data(), count, stackFile);
}

void printStack() {
  std::array<char, 1024> text;
  if (lseek(stackFile, 0, SEEK_SET) != 0) return;
  ssize_t size = 0;
  while ((size = read(stackFile, text.data(), text.size())) > 0) {
    if (write(STDERR_FILENO, text.data(), static_cast<std::size_t>(size)) != size) return;
  }
}

std::atomic<pid_t> crashedThread = 0;

extern "C" void onCrash(int signal) {
  // A driver's threads may crash at the same time; the first one ends the process.
  pid_t first = 0;
  const bool isFirst = crashedThread.compare_exchange_strong(first, gettid());
  while (!isFirst && first != gettid()) pause();
  keepStack();
  system::becomeCrashSuccessor(signal);
  printStack();
  printCrash(kCrash);
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Gives the handlers a stack of their own on this thread, since one that overflowed has no room.
void useSignalStack() {
  static std::array<char, 65536> memory;
  const stack_t stack{.ss_sp = memory.data(), .ss_flags = 0, .ss_size = memory.size()};
  stack_t before{};
  sigaltstack(nullptr, &before);
  // Sanitizers have one, which they give back.
  if ((before.ss_flags & SS_DISABLE) != 0) sigaltstack(&stack, nullptr);
}

thread_local bool memoryRanOut = false;
std::terminate_handler terminateOtherwise = std::abort;

void onOutOfMemory() {
  memoryRanOut = true;
  throw std::bad_alloc();
}

// Some library functions are noexcept and allocate memory all the same.
[[noreturn]] void onTerminate() {
  if (!memoryRanOut) {
    terminateOtherwise();
    std::abort();
  }
  printCrash(kOutOfMemory);
  _exit(endStatus(kTryAgain));
}

}  // namespace

void adviseResume() {
  mayResume = true;
}

std::string_view crashAdvice() {
  return mayResume ? kResume : std::string_view("\n");
}

int crashStackFile() {
  return stackFile;
}

void takeCrashStack(int file) {
  stackFile = file;
}

void reportCrashes() {
  stackFile = memfd_create("stack", 0);
  std::array<void*, 1> frame{};
  backtrace(frame.data(), 1);  // Its first call loads a library, which no handler may.
  std::set_new_handler(onOutOfMemory);
  terminateOtherwise = std::set_terminate(onTerminate);
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = SA_ONSTACK;
  // A crash of the handler itself ends the process.
  for (const int signal : system::kCrashSignals) sigaddset(&action.sa_mask, signal);
  useSignalStack();
  for (const int signal : system::kCrashSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // Sanitizers, which have handlers of their own, report more.
    if (before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

}  // namespace rotatebook::cli
