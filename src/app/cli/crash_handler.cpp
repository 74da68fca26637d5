#include "cli/crash_handler.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

#include "cli/exit_code.h"
#include "system/crash_signals.h"

namespace rotatebook::cli {
namespace {

constexpr std::string_view kCrash =
    "rotatebook: crashed, in its own code or in a driver; 'rotatebook doctor' tries each driver";
constexpr std::string_view kOutOfMemory = "rotatebook: out of memory";
constexpr std::string_view kRemedy =
    ". What a render had finished is kept: go on with the same command and --resume\n";

// Calls only functions that are safe in a signal handler.
void printCrash(std::string_view problem) {
  for (const std::string_view text : {problem, kRemedy}) {
    // A failure can't be reported anywhere.
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
  }
}

extern "C" void onCrash(int signal) {
  printCrash(kCrash);
  raise(signal);  // SA_RESETHAND restored its default effect.
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
  _exit(kMachineFailed);
}

}  // namespace

void reportCrashes() {
  std::set_new_handler(onOutOfMemory);
  terminateOtherwise = std::set_terminate(onTerminate);
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : system::kCrashSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // Sanitizers, which have handlers of their own, report more.
    if (before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

}  // namespace rotatebook::cli
