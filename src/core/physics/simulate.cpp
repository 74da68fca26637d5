#include "physics/simulate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

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

/// Advances a simulator through one frame, and stops on the way for nudges or at a time within: a
/// step in which one falls is made in parts.
class PartsOfFrame {
 public:
  PartsOfFrame(Simulator& simulator, const SimulationSettings& stepping)
      : simulator_(simulator),
        steps_(stepping.substeps),
        h_(stepping.timePerFrame / stepping.substeps) {}

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

/// Returns the nudges after `start` and up to `end`. [s]
std::span<const Nudge> nudgesWithin(std::span<const Nudge> nudges, double start, double end) {
  const auto isAfter = [](double time, const Nudge& nudge) { return time < nudge.at; };
  const auto first = std::upper_bound(nudges.begin(), nudges.end(), start, isAfter);
  return {first, std::upper_bound(first, nudges.end(), end, isAfter)};
}

/// A body's motion, of which the states at ascending times can be had. The simulator itself stops
/// only at whole frames.
class Course {
 public:
  explicit Course(const MotionSettings& settings)
      : nudges_(settings.nudges),
        stepping_(settings.simulation),
        simulator_(makeSimulator(settings)) {}

  /// Returns the state at a time not before those so far. [s]
  BodyState at(double time) {
    const double slack = kEndOfStep * stepping_.timePerFrame / stepping_.substeps;
    while (startOf(frame_ + 1) <= time + slack) makeFrame();
    if (time - startOf(frame_) <= slack) return simulator_->state();
    const auto copy = simulator_->copy();
    advanceWithin(*copy, time);
    return copy->state();
  }

 private:
  double startOf(std::int64_t frame) const {
    return static_cast<double>(frame) * stepping_.timePerFrame;
  }

  void makeFrame() {
    const double end = startOf(frame_ + 1);
    const bool isExact = stepping_.model == Model::Exact;
    if (isExact || nudgesWithin(nudges_, startOf(frame_), end).empty()) {
      simulator_->advance(stepping_.timePerFrame, stepping_.substeps);
    } else {
      partsTo(*simulator_, end).finish();
    }
    ++frame_;
  }

  /// Advances a simulator that is at the start of the frame to a time within it. [s]
  void advanceWithin(Simulator& simulator, double time) const {
    const double offset = time - startOf(frame_);
    if (stepping_.model == Model::Exact) {
      simulator.advance(offset, 1);
    } else {
      partsTo(simulator, time).advanceTo(offset);
    }
  }

  /// Returns the frame's parts, advanced through the nudges up to `end`. [s]
  PartsOfFrame partsTo(Simulator& simulator, double end) const {
    PartsOfFrame parts(simulator, stepping_);
    for (const Nudge& nudge : nudgesWithin(nudges_, startOf(frame_), end)) {
      parts.advanceTo(nudge.at - startOf(frame_));
      simulator.nudge(nudge);
    }
    return parts;
  }

  std::vector<Nudge> nudges_;
  SimulationSettings stepping_;
  std::unique_ptr<Simulator> simulator_;
  std::int64_t frame_ = 0;  // the frame at whose start the simulator is
};

std::vector<double> evenTimes(double interval, std::int64_t count) {
  std::vector<double> times;
  for (std::int64_t n = 0; n < count; ++n) times.push_back(static_cast<double>(n) * interval);
  return times;
}

}  // namespace

Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop) {
  return simulate(settings, evenTimes(settings.simulation.timePerFrame, sampleCount), stop);
}

struct Simulation::Parts {
  explicit Parts(const MotionSettings& settings)
      : body(settings.body), course(settings), measurement(settings) {
    trajectory.interval = settings.simulation.timePerFrame;
  }

  Cuboid body;
  Course course;
  Measurement measurement;
  Trajectory trajectory;
};

Simulation::Simulation(const MotionSettings& settings) {
  requireSameLayout();
  parts_ = std::make_unique<Parts>(settings);
  if (!sample(0)) throw InputError("the motion's start is not finite: its numbers are too large");
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::sample(double time) {
  Trajectory& result = parts_->trajectory;
  if (result.divergedAt) return false;
  const BodyState state = parts_->course.at(time);
  if (hasBlownUp(state, parts_->body)) {
    result.divergedAt = time;
    return false;
  }
  result.samples.push_back(parts_->measurement.measure(time, state));
  return true;
}

const Trajectory& Simulation::trajectory() const {
  return parts_->trajectory;
}

Trajectory simulate(const MotionSettings& settings, std::span<const double> times,
                    const std::atomic<bool>* stop) {
  Simulation simulation(settings);
  for (const double time : times.subspan(1)) {
    if ((stop != nullptr && *stop) || !simulation.sample(time)) break;
  }
  return simulation.trajectory();
}

}  // namespace rotatebook::physics
