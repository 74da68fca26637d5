// Runs of code that may crash, in a copy of the process.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace rotatebook::system {

/// Runs `action` in a copy of this process (fork) and reports how that ended: empty if the action
/// returned or threw; else "ends the process (Segmentation fault)" or "doesn't return within 60 s",
/// and the last line of its standard error, which is kept from the terminal. Call it while the
/// process has no other threads: the copy lacks them. Throws MachineError if no other process can
/// be started.
std::string runIsolated(const std::function<void()>& action, std::chrono::seconds timeout);

}  // namespace rotatebook::system
