#include "physics/simulate.h"

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/layout.h"
#include "physics/course.h"
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

std::vector<double> evenTimes(double interval, std::int64_t count) {
  std::vector<double> times;
  for (std::int64_t n = 0; n < count; ++n) times.push_back(static_cast<double>(n) * interval);
  return times;
}

}  // namespace

bool hasBlownUp(const BodyState& state, const body::Cuboid& body) {
  const body::Cage cage = drawnCage(state, body);
  return !isFinite(state) || !cage.allFinite() ||
         cage.colwise().norm().maxCoeff() > kDivergenceFactor * body.largestDimension();
}

Trajectory simulate(const MotionSettings& settings, std::int64_t sampleCount,
                    const std::atomic<bool>* stop) {
  return simulate(settings, evenTimes(settings.simulation.timePerFrame, sampleCount), stop);
}

struct Simulation::Parts {
  Parts(const MotionSettings& settings, Compared compared)
      : body(settings.body), course(settings), measurement(settings, compared) {
    trajectory.interval = settings.simulation.timePerFrame;
  }

  body::Cuboid body;
  Course course;
  Measurement measurement;
  Trajectory trajectory;
};

Simulation::Simulation(const MotionSettings& settings, Compared compared) {
  requireSameLayout();
  parts_ = std::make_unique<Parts>(settings, compared);
  if (!sample(0)) throw InputError("the motion's start is not finite: its numbers are too large");
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::sample(double time) {
  const std::optional<Sample> next = sampleOnce(time);
  if (next) parts_->trajectory.samples.push_back(*next);
  return next.has_value();
}

std::optional<Sample> Simulation::sampleOnce(double time) {
  Trajectory& result = parts_->trajectory;
  if (result.divergedAt) return std::nullopt;
  const BodyState state = parts_->course.at(time);
  if (!hasBlownUp(state, parts_->body)) return parts_->measurement.measure(time, state);
  result.divergedAt = time;
  return std::nullopt;
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
