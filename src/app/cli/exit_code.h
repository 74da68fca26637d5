// What the program's exit status means; documented in the README. Inside the room only.
#pragma once

namespace rotatebook::cli {

enum ExitCode : int {
  kDone = 0,
  kUnmet = 1,          ///< An expectation or a comparison failed.
  kWrongInput = 2,     ///< The user's input is wrong.
  kMachineFailed = 3,  ///< The machine can't: no EGL, no encoder, disk.
  kInterrupted = 129,  ///< Least of those after a signal: SIGHUP; SIGINT gives 130, SIGTERM 143.
};

}  // namespace rotatebook::cli
