// Error messages and the exit statuses that belong to them. Inside the room only.
#pragma once

#include <exception>
#include <string_view>

namespace rotatebook::cli {

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
