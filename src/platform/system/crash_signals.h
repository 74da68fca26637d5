// The signals by which a process ends that its own code, or a driver's, has brought down.
#pragma once

#include <array>
#include <csignal>

namespace rotatebook::system {

inline constexpr std::array kCrashSignals{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

}  // namespace rotatebook::system
