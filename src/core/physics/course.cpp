#include "physics/course.h"

#include <algorithm>
#include <cmath>

#include "physics/make_simulator.h"
#include "physics/motion_start.h"

namespace rotatebook::physics {
namespace {

// Times within a step that are closer to its ends than this part of it are taken for the ends.
constexpr double kEndOfStep = 1e-9;

/// Returns the nudges after `start` and up to `end`. [s]
std::span<const Nudge> nudgesWithin(std::span<const Nudge> nudges, double start, double end) {
  const auto isAfter = [](double time, const Nudge& nudge) { return time < nudge.at; };
  const auto first = std::upper_bound(nudges.begin(), nudges.end(), start, isAfter);
  return {first, std::upper_bound(first, nudges.end(), end, isAfter)};
}

BodyState turned(const Eigen::Matrix3d& turn, BodyState state) {
  state.worldFromBody = turn * state.worldFromBody;
  if (state.cage) state.cage = body::Cage(turn * *state.cage);
  state.angularVelocity = turn * state.angularVelocity;
  state.angularMomentum = turn * state.angularMomentum;
  return state;
}

}  // namespace

/// Advances a simulator through one frame, and stops on the way for nudges or at a time within: a
/// step in which one falls is made in parts.
class PartsOfFrame {
 public:
  PartsOfFrame(Simulator& simulator, const EqualSteps& steps)
      : simulator_(simulator), steps_(steps.count), h_(steps.length()) {}

  /// Advances to `offset` from the frame's start. [s]
  void advanceTo(double offset) {
    const double steps = offset / h_;
    const double whole = std::min(std::floor(steps + kEndOfStep), 1.0 * steps_);
    const double part = steps - whole;
    advanceTo(static_cast<int>(whole), part > kEndOfStep ? part * h_ : 0);
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
    if (part > part_) simulator_.advancePart(part - part_);
    part_ = part;
  }

  Simulator& simulator_;
  int steps_;
  double h_;         // a whole step [s]
  int whole_ = 0;    // steps made
  double part_ = 0;  // of the next step [s]
};

Course::Course(const MotionSettings& settings)
    : Course(initialAttitude(settings.initial), withoutAttitude(settings)) {}

Course::Course(const std::optional<Eigen::Matrix3d>& attitude, const MotionSettings& upright)
    : attitude_(attitude),
      nudges_(upright.nudges),
      steps_(upright.simulation.steps()),
      simulator_(makeSimulator(upright)) {}

BodyState Course::at(double time) {
  const BodyState state = unturned(time);
  return attitude_ ? turned(*attitude_, state) : state;
}

BodyState Course::unturned(double time) {
  if (simulator_->jumpTo(time)) return simulator_->state();
  const double slack = kEndOfStep * steps_.time / steps_.count;
  while (startOf(frame_ + 1) <= time + slack) makeFrame();
  if (time - startOf(frame_) <= slack) return simulator_->state();
  const auto copy = simulator_->copy();
  advanceWithin(*copy, time);
  return copy->state();
}

void Course::makeFrame() {
  const double end = startOf(frame_ + 1);
  if (nudgesWithin(nudges_, startOf(frame_), end).empty()) {
    simulator_->advance(steps_.time, steps_.count);
  } else {
    partsTo(*simulator_, end).finish();
  }
  ++frame_;
}

/// Advances a simulator that is at the start of the frame to a time within it. [s]
void Course::advanceWithin(Simulator& simulator, double time) const {
  partsTo(simulator, time).advanceTo(time - startOf(frame_));
}

/// Returns the frame's parts, advanced through the nudges up to `end`. [s]
PartsOfFrame Course::partsTo(Simulator& simulator, double end) const {
  PartsOfFrame parts(simulator, steps_);
  for (const Nudge& nudge : nudgesWithin(nudges_, startOf(frame_), end)) {
    parts.advanceTo(nudge.at - startOf(frame_));
    simulator.nudge(nudge);
  }
  return parts;
}

}  // namespace rotatebook::physics
