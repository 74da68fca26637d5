// Execution of studies on this machine. Inside the room only.
#pragma once

#include "study/execution.h"
#include "system/parallel_runs.h"

namespace rotatebook::cli {

/// Makes a study's runs on threads, as system::runParallel() does with `options`, and measures each
/// run's step: the smallest of several measurements of the thread's processor time.
study::Execution onThisMachine(const system::RunOptions& options = {});

}  // namespace rotatebook::cli
