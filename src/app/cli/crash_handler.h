// Last words of a process that crashes. Inside the room only.
#pragma once

namespace rotatebook::cli {

/// From now on a crash (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT) that nobody else handles is told
/// in one line, with what to do, before it ends the process as it would have. So is a want of
/// memory where no exception may pass; the exit status is that of a machine that can't.
void reportCrashes();

}  // namespace rotatebook::cli
