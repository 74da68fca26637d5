#include "diagnose/study_execution.h"

#include "diagnose/step_timer.h"

namespace rotatebook::diagnose {

study::Execution onThisMachine(const system::RunOptions& options) {
  return {.runAll = [options](std::span<const std::size_t> indices,
                              const study::Run& run) { return runParallel(indices, run, options); },
          .nanosecondsPerStep = nanosecondsPerStep,
          .stop = options.stop};
}

}  // namespace rotatebook::diagnose
