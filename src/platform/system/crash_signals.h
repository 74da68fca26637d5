// Signals that end a process after a crash in its own code or a driver's.
#pragma once

#include <array>
#include <csignal>

namespace rotatebook::system {

inline constexpr std::array kCrashSignals{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

}  // namespace rotatebook::system
