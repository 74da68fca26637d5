#include "physics/simulate.h"

#include <cmath>

#include "base/error.h"
#include "base/layout.h"
#include "physics/make_simulator.h"
#include "physics/measure/measurement.h"

namespace rotatebook::physics {

const std::size_t kSampleSize = sizeof(Sample);
const std::size_t kTrajectorySize = sizeof(Trajectory);
const std::size_t kBodyStateSize = sizeof(BodyState);

namespace {

bool isFinite(const BodyState& state) {
  return state.angularVelocity.allFinite() && state.angularMomentum.allFinite() &&
         std::isfinite(state.kinetic) && std::isfinite(state.potential) &&
         std::isfinite(state.rotational);
}

bool hasBlownUp(const BodyState& state, const Cuboid& body) {
  const Cage cage = drawnCage(state, body);
  return !isFinite(state) || !cage.allFinite() ||
         cage.colwise().norm().maxCoeff() > kDivergenceFactor * body.largestDimension();
}

}  // namespace

Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop) {
  requireSameLayout();
  const auto simulator = makeSimulator(settings);
  Measurement measurement(settings);
  const SimulationSettings& stepping = settings.simulation;

  Trajectory result;
  result.interval = stepping.timePerFrame;
  for (std::int64_t n = 0; n < sampleCount; ++n) {
    if (n > 0) simulator->advance(stepping.timePerFrame, stepping.substeps);
    const double time = static_cast<double>(n) * result.interval;
    const BodyState state = simulator->state();
    if (hasBlownUp(state, settings.body)) {
      result.divergedAt = time;
      break;
    }
    result.samples.push_back(measurement.measure(time, state));
    if (stop != nullptr && *stop) break;
  }
  if (result.samples.empty())
    throw InputError("the motion's start is not finite: its numbers are too large");
  return result;
}

}  // namespace rotatebook::physics
