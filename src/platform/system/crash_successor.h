// A run of this program that takes the place of one that crashes.
#pragma once

#include <string>
#include <vector>

namespace rotatebook::system {

/// Prepares the arguments, from argv[0] on, with which this program starts anew in the place of a
/// process that crashes; the crash signal's number, of two digits, is added as the last one. Call
/// it on one thread at a time.
void setCrashSuccessor(std::vector<std::string> arguments);

/// Starts the prepared run in the place of this process (exec), whose other threads end; files that
/// it was writing stay as they are. Returns if nothing was prepared, or without /proc. To be called
/// by the handler of a crash signal, in which it is safe.
void becomeCrashSuccessor(int signal) noexcept;

}  // namespace rotatebook::system
