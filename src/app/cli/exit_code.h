// The program's exit statuses, as docs/troubleshooting.md has them, and the messages of the errors
// that they belong to. Inside the room only.
#pragma once

#include <exception>
#include <string_view>

namespace rotatebook::cli {

enum ExitCode : int {
  kDone = 0,
  kUnmet = 1,          ///< An expectation, a comparison or a proof failed.
  kWrongInput = 2,     ///< The user's input is wrong.
  kMachineFailed = 3,  ///< The machine can't do it: no EGL, no encoder, a full disk.
  kCoarse = 4,         ///< A clip is consistent with its scene, but its pictures can't be proved.
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

/// Prints "rotatebook: `subject``message`" to the standard error.
void printError(std::string_view message, std::string_view subject = "");

/// Prints "rotatebook: `subject`MESSAGE" to the standard error; returns the exit status for such an
/// error. Allocates no memory, as the error may be that there is none.
int reportError(const std::exception_ptr& error, std::string_view subject = "");

/// Returns the exit status of `work`; reports what it throws, and returns the status of that.
template <typename Work>
int guarded(const Work& work) noexcept {
  try {
    return work();
  } catch (...) {
    return reportError(std::current_exception());
  }
}

/// Returns `status`; if it is kUnmet, prints a line to the standard error first: about files, too,
/// if the command wrote any.
int reportIfUnmet(int status, bool wroteFiles = true);

}  // namespace rotatebook::cli
