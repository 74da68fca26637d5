#include "cli/interrupt.h"

#include <array>
#include <csignal>

namespace rotatebook::cli {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<int> received = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// Calls nothing but what a signal handler may.
extern "C" void onSignal(int signal) {
  // The next one has its default effect, whichever it is; what is ignored stays so.
  for (const int next : kSignals) {
    struct sigaction now {};
    sigaction(next, nullptr, &now);
    if (now.sa_handler == onSignal) std::signal(next, SIG_DFL);
  }
  received = signal;
  interrupted = true;
}

}  // namespace

const std::atomic<bool>& catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  // Of two that come at once the second waits until the first has reset it.
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // nohup and shells have some of them ignored.
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  // A render goes on though nobody listens any more, and tells in the end.
  std::signal(SIGPIPE, SIG_IGN);
  return interrupted;
}

int interruptStatus() {
  return received == 0 ? 0 : 128 + received;
}

}  // namespace rotatebook::cli
