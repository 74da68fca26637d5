#include "cli/crash_words.h"

#include <csignal>
#include <string_view>
#include <unistd.h>

namespace rotatebook::cli {
namespace {

constexpr std::string_view kWords =
    "rotatebook: crashed, in its own code or in a driver; 'rotatebook doctor' tries each driver. "
    "What a render had finished is kept: go on with the same command and --resume\n";

// Calls nothing but what a signal handler may.
extern "C" void onCrash(int signal) {
  if (write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) {
    // There is nobody to tell.
  }
  raise(signal);  // Its default effect now.
}

}  // namespace

void speakBeforeCrashes() {
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // Sanitizers say more.
    if (before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

}  // namespace rotatebook::cli
