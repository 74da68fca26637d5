// Execution of studies on this machine.
#pragma once

#include "study/execution.h"
#include "system/parallel_runs.h"

namespace rotatebook::diagnose {

/// Makes a study's runs on threads, as system::runParallel() does with `options`, and measures each
/// run's step as nanosecondsPerStep() does.
study::Execution onThisMachine(const system::RunOptions& options = {});

}  // namespace rotatebook::diagnose
