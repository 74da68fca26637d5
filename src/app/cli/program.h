// The command line. Inside the room only.
#pragma once

namespace rotatebook::cli {

/// Runs the program; returns its exit status (see ExitCode). Never throws.
int runProgram(int argc, char** argv);

}  // namespace rotatebook::cli
