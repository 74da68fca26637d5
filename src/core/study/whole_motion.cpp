#include "study/whole_motion.h"

#include <algorithm>
#include <numeric>

#include "physics/integrators/step_error.h"
#include "physics/simulate.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;

// Puts the longest runs first: a long run that starts last keeps all other threads waiting.
std::vector<std::size_t> longestFirst(const std::vector<MotionSettings>& runs) {
  std::vector<std::size_t> indices(runs.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::ranges::stable_sort(indices, std::ranges::less{},
                           [&](std::size_t i) { return runs[i].simulation.steps().length(); });
  return indices;
}

}  // namespace

bool isSet(const std::atomic<bool>* stop) {
  return stop != nullptr && *stop;
}

std::optional<Trajectory> wholeMotion(const MotionSettings& settings, std::int64_t frames,
                                      const std::atomic<bool>* stop, RunEnd& end) {
  try {
    Trajectory trajectory = simulate(settings, frames, stop);
    if (!trajectory.divergedAt) return trajectory;
    end = {RunEnd::Kind::Diverged, *trajectory.divergedAt};
  } catch (const physics::NoConvergence&) {
    end = {RunEnd::Kind::NoConvergence};
  } catch (const physics::StepTooLong&) {
    end = {RunEnd::Kind::StepTooLong};
  }
  return std::nullopt;
}

bool makeRuns(const std::vector<MotionSettings>& settings, const Run& run,
              const Execution& execution) {
  return execution.runAll(longestFirst(settings), run) && !isSet(execution.stop);
}

}  // namespace rotatebook::study
