// Last words of a process that crashes.
#pragma once

namespace rotatebook::cli {

/// From now on a crash (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT) that nobody else handles is told
/// in one line, with what to do, before it ends the process as it would have.
void speakBeforeCrashes();

}  // namespace rotatebook::cli
