// SIGINT, SIGTERM and SIGHUP as a flag. Inside the room only.
#pragma once

#include <atomic>

namespace rotatebook::cli {

/// From now on the first SIGINT, SIGTERM or SIGHUP, unless it is ignored, sets the flag that is
/// returned; a second one ends the process. A pipe that nobody reads is an error of printing.
const std::atomic<bool>& catchInterrupts();

/// 130 after SIGINT, 143 after SIGTERM, 129 after SIGHUP, 0 if there was none.
int interruptStatus();

}  // namespace rotatebook::cli
