// A message from a process that crashes. Inside the room only.
#pragma once

namespace rotatebook::cli {

/// Installs handlers that print one line, with what to do, when SIGSEGV, SIGBUS, SIGILL, SIGFPE or
/// SIGABRT arrives and nobody else handles it; the signal then ends the process as it would have.
/// Running out of memory where no exception may pass is reported, too, and exits with
/// kMachineFailed.
void reportCrashes();

}  // namespace rotatebook::cli
