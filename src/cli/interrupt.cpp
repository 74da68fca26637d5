#include "cli/interrupt.h"

#include <csignal>

namespace rotatebook::cli {
namespace {

std::atomic<bool> interrupted = false;
std::atomic<int> received = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void onSignal(int signal) {
  received = signal;
  interrupted = true;
}

}  // namespace

const std::atomic<bool>& catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESETHAND | SA_RESTART;  // The second signal has its default effect.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
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
