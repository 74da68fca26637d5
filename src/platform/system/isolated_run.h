// What may end the process is tried in a copy of it first.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace rotatebook::system {

/// Runs `action` in a copy of this process (fork) and tells how that ended: empty if the action
/// came back or threw; else "ends the process (Segmentation fault)" or "doesn't come back
/// within 60 s", and what was written last to standard error, which is kept from the terminal.
/// Call it while the process has no other threads: the copy lacks them.
/// Throws MachineError if there can't be another process.
std::string runIsolated(const std::function<void()>& action, std::chrono::seconds longest);

}  // namespace rotatebook::system
