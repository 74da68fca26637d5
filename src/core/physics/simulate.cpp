#include "physics/simulate.h"

#include <algorithm>
#include <cmath>
#include <span>

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

// Times within a step that are closer to its ends than this part of it are taken for the ends.
constexpr double kEndOfStep = 1e-9;

/// Advances a simulator through one frame, and stops on the way for nudges: a step in which one
/// falls is made in parts.
class FrameWithNudges {
 public:
  FrameWithNudges(Simulator& simulator, const SimulationSettings& stepping)
      : simulator_(simulator),
        steps_(stepping.substeps),
        h_(stepping.timePerFrame / stepping.substeps) {}

  /// Advances to `offset` from the frame's start, and nudges there. [s]
  void nudgeAt(double offset, const Nudge& nudge) {
    const double steps = offset / h_;
    const double whole = std::min(std::floor(steps + kEndOfStep), 1.0 * steps_);
    const double part = steps - whole;
    advanceTo(static_cast<int>(whole), part > kEndOfStep ? part * h_ : 0);
    simulator_.nudge(nudge);
  }

  void finish() { advanceTo(steps_, 0); }

 private:
  /// Advances to `whole` steps and a part of the next. [s]
  void advanceTo(int whole, double part) {
    if (whole > whole_ && part_ > 0) {
      simulator_.advance(h_ - part_, 1);
      ++whole_;
      part_ = 0;
    }
    for (; whole_ < whole; ++whole_) simulator_.advance(h_, 1);
    if (part > part_) simulator_.advance(part - part_, 1);
    part_ = part;
  }

  Simulator& simulator_;
  int steps_;
  double h_;         // a whole step [s]
  int whole_ = 0;    // steps made
  double part_ = 0;  // of the next step [s]
};

/// Advances by a frame that begins at `start` [s] and in which `nudges` fall.
void advance(Simulator& simulator, const SimulationSettings& stepping, double start,
             std::span<const Nudge> nudges) {
  if (nudges.empty() || stepping.model == Model::Exact) {
    simulator.advance(stepping.timePerFrame, stepping.substeps);
    return;
  }
  FrameWithNudges frame(simulator, stepping);
  for (const Nudge& nudge : nudges) frame.nudgeAt(nudge.at - start, nudge);
  frame.finish();
}

/// Returns the nudges after `start` and up to `end`. [s]
std::span<const Nudge> nudgesWithin(std::span<const Nudge> nudges, double start, double end) {
  const auto isAfter = [](double time, const Nudge& nudge) { return time < nudge.at; };
  const auto first = std::upper_bound(nudges.begin(), nudges.end(), start, isAfter);
  return {first, std::upper_bound(first, nudges.end(), end, isAfter)};
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
    const double time = static_cast<double>(n) * result.interval;
    if (n > 0) {
      const double before = static_cast<double>(n - 1) * result.interval;
      advance(*simulator, stepping, before, nudgesWithin(settings.nudges, before, time));
    }
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
