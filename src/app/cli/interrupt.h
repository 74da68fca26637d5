// Effects of SIGINT, SIGTERM and SIGHUP. Inside the room only.
#pragma once

#include <atomic>

namespace rotatebook::cli {

/// Installs handlers by which the first SIGINT, SIGTERM or SIGHUP, unless it is ignored, sets the
/// returned flag; a second one ends the process. Ignores SIGPIPE, so that writing to a pipe that
/// nobody reads is an output error.
const std::atomic<bool>& catchInterrupts();

/// Makes the first SIGINT, SIGTERM or SIGHUP end the process at once with kTryAgain, if that is
/// asked for; else they keep their effect. For commands that leave no unfinished file.
void endAtInterrupts();

/// Returns 130 after SIGINT, 143 after SIGTERM, 129 after SIGHUP, and 0 if there was none.
int interruptStatus();

}  // namespace rotatebook::cli
