#include "cli/interrupt.h"

#include <array>
#include <csignal>
#include <unistd.h>

#include "cli/exit_code.h"

namespace rotatebook::cli {
namespace {

std::atomic<bool> stopAsked = false;
std::atomic<int> received = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// Calls only functions that are safe in a signal handler.
extern "C" void onSignal(int signal) {
  // The next signal, whichever it is, has its default effect; ignored ones stay ignored.
  for (const int next : kSignals) {
    struct sigaction now {};
    sigaction(next, nullptr, &now);
    if (now.sa_handler == onSignal) std::signal(next, SIG_DFL);
  }
  received = signal;
  stopAsked = true;
}

extern "C" void endWithStatus(int signal) {
  _exit(endStatus(128 + signal));
}

void handleInterrupts(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  // If two arrive at once, the second waits until the first has restored its default effect.
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // nohup and shells start programs with some of them ignored.
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

}  // namespace

const std::atomic<bool>& catchInterrupts() {
  handleInterrupts(onSignal);
  // A render goes on when its output pipe is closed, and reports that at the end.
  std::signal(SIGPIPE, SIG_IGN);
  return stopAsked;
}

void endAtInterrupts() {
  if (endStatus(kInterrupted) != kInterrupted) handleInterrupts(endWithStatus);
}

int interruptStatus() {
  return received == 0 ? 0 : 128 + received;
}

}  // namespace rotatebook::cli
