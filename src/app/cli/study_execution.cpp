#include "cli/study_execution.h"

#include <algorithm>
#include <ctime>
#include <memory>
#include <vector>

#include "physics/make_simulator.h"

namespace rotatebook::cli {
namespace {

// A measurement must take far longer than reading the clock, a few tenths of a microsecond.
constexpr std::int64_t kStepsPerMeasurement = 4096;
constexpr int kMinMeasurements = 5;
constexpr int kMaxMeasurements = 200;
constexpr double kEnough = 4e6;  // Of all measurements together. [ns]

double threadTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

using Fleet = std::vector<std::unique_ptr<physics::Simulator>>;

// A motion of few steps is simulated several times from the start, because steps beyond its end may
// cost something else.
Fleet makeFleet(const physics::MotionSettings& settings, std::int64_t stepsEach) {
  Fleet fleet;
  for (std::int64_t steps = 0; steps < kStepsPerMeasurement; steps += stepsEach) {
    fleet.push_back(makeSimulator(settings));
  }
  return fleet;
}

double timeOnce(const Fleet& fleet, double h, int steps) {
  const double start = threadTime();
  for (const auto& simulator : fleet) simulator->advance(h * steps, steps);
  return threadTime() - start;
}

/// Returns the computing time of one integration step, the smallest of several measurements. [ns]
/// It is the calling thread's processor time, which other programs and threads disturb little; it
/// differs from run to run all the same. Repeats the first `steps` >= 1 steps of the motion, or
/// fewer; takes some milliseconds. Throws StepError.
double nanosecondsPerStep(const physics::MotionSettings& settings, std::int64_t steps) {
  const double h = settings.simulation.steps().length();
  const auto stepsEach = static_cast<int>(std::min(steps, kStepsPerMeasurement));
  double best = 0;
  double spent = 0;
  for (int n = 0; n < kMaxMeasurements; ++n) {
    if (n >= kMinMeasurements && spent > kEnough) break;
    const Fleet fleet = makeFleet(settings, stepsEach);
    const double time = timeOnce(fleet, h, stepsEach);
    const double perStep = time / (static_cast<double>(fleet.size()) * stepsEach);
    best = n == 0 ? perStep : std::min(best, perStep);
    spent += time;
  }
  return best;
}

}  // namespace

study::Execution onThisMachine(const system::RunOptions& options) {
  return {.runAll = [options](std::span<const std::size_t> indices,
                              const study::Run& run) { return runParallel(indices, run, options); },
          .nanosecondsPerStep = nanosecondsPerStep,
          .stop = options.stop};
}

}  // namespace rotatebook::cli
