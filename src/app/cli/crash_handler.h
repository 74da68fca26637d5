// A message from a process that crashes. Inside the room only.
#pragma once

#include <string_view>

namespace rotatebook::cli {

/// Has the message advise --resume from now on, as the command is one that has it.
void adviseResume();

/// Returns the end of the message: the advice if it was asked for, and a line end.
std::string_view crashAdvice();

/// Returns the number of the file in which a crash leaves the stack of its thread, for the process
/// that takes this one's place; -1 if there can be none.
int crashStackFile();

/// Has a crash report the stack that the process before this one left in such a file.
void takeCrashStack(int file);

/// Installs handlers that print where the program was and one line, with what to do, when SIGSEGV,
/// SIGBUS, SIGILL, SIGFPE or SIGABRT arrives and nobody else handles it; the signal then ends the
/// process as it would have. In place of that line, a process that draws starts the command
/// `after-crash`, if it can. Running out of memory where no exception may pass is reported, too,
/// and exits with kMachineFailed.
void reportCrashes();

}  // namespace rotatebook::cli
