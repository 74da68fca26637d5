// The program's exit statuses; documented in docs/troubleshooting.md. Inside the room only.
#pragma once

namespace rotatebook::cli {

enum ExitCode : int {
  kDone = 0,
  kUnmet = 1,          ///< An expectation, a comparison or a proof failed.
  kWrongInput = 2,     ///< The user's input is wrong.
  kMachineFailed = 3,  ///< The machine can't do it: no EGL, no encoder, a full disk.
  kCoarse = 4,         ///< A clip is consistent with its scene, but too coarse to prove it.
  /// Like kMachineFailed, but another try may succeed: EX_TEMPFAIL of sysexits.h. The program ends
  /// with it only if it is asked for: endStatus().
  kTryAgain = 75,
  kInterrupted = 129,  ///< SIGHUP; SIGINT gives 130, SIGTERM 143. The lowest of the three.
};

/// Returns the status of a command whose expectations or comparisons are `met`, or not.
constexpr int statusOf(bool met) {
  return met ? kDone : kUnmet;
}

/// Asks for kTryAgain as the program's exit status, in the place of others, where it helps.
void askForRetryStatus();

/// Returns the program's exit status if a command's is `status`: kTryAgain and those of interrupts
/// are that if it is asked for; else kTryAgain is kMachineFailed. May be called in any state.
int endStatus(int status) noexcept;

}  // namespace rotatebook::cli
