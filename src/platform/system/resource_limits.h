// The limits of this process that `ulimit` sets.
#pragma once

#include <string>
#include <vector>

namespace rotatebook::system {

/// Throws MachineError, with the remedy, if the stack may be so small that a render overflows it,
/// which would end the process.
void requireStack();

/// Lists the limits on this process's memory that are less than the machine's memory:
/// "ulimit -d (it is 100000 kB)".
std::vector<std::string> memoryLimits();

}  // namespace rotatebook::system
