#include "engines/comparison.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "physics/measure/measurement.h"
#include "rigid/exact_motion.h"

namespace rotatebook::bench {
namespace {

constexpr int kLooks = 200;  // kDuration / kInterval
static_assert(kLooks * kInterval == kDuration);

std::vector<EngineState> exactLooks(const Motion& motion) {
  const rigid::ExactMotion exact(motion.book.solidInertia(), motion.angularVelocity);
  std::vector<EngineState> looks;
  for (int i = 1; i <= kLooks; ++i) {
    const auto moment = exact.at(i * kInterval);
    looks.push_back({moment.worldFromBody, moment.worldFromBody * moment.angularVelocityBody});
  }
  return looks;
}

int stepsIn(double time, double step) {
  return static_cast<int>(std::lround(time / step));
}

std::vector<EngineState> engineLooks(Engine& engine, int stepsBetween) {
  std::vector<EngineState> looks;
  for (int i = 0; i < kLooks; ++i) {
    engine.advance(stepsBetween);
    looks.push_back(engine.state());
  }
  return looks;
}

/// The angle of the rotation from one attitude to the other. [rad]
double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::Quaterniond(a).angularDistance(Eigen::Quaterniond(b));
}

/// Processor time of this thread so far. [ns]
double threadNanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// A step's time in the fastest of many runs: what disturbs a run only makes it slower. [ns]
double nanosecondsAStep(const Mode& mode, const Motion& motion, double step) {
  constexpr double kEnough = 0.2e9;  // [ns]
  constexpr int kMinRuns = 3;
  const int steps = stepsIn(kDuration, step);
  double fastest = std::numeric_limits<double>::infinity();
  double total = 0;
  for (int run = 0; run < kMinRuns || total < kEnough; ++run) {
    const std::unique_ptr<Engine> engine = mode.make(motion, step);
    const double begin = threadNanoseconds();
    engine->advance(steps);
    const double spent = threadNanoseconds() - begin;
    total += spent;
    fastest = std::min(fastest, spent / engine->chosenSteps().value_or(steps));
  }
  return fastest;
}

}  // namespace

Comparison::Comparison(const Motion& motion)
    : motion_(motion),
      inertia_(motion.book.solidInertia()),
      exact_(exactLooks(motion)),
      exactHalfTurns_(countHalfTurns(exact_)) {}

Row Comparison::run(const Mode& mode, double step) const {
  const std::unique_ptr<Engine> engine = mode.make(motion_, step);
  const EngineState start = engine->state();
  const auto looks = engineLooks(*engine, stepsIn(kInterval, step));
  const EngineState& end = looks.back();
  Row row;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    row.lastError = angleBetween(looks[i].worldFromBody, exact_[i].worldFromBody);
    row.largestError = std::max(row.largestError, row.lastError);
  }
  // Twice the energy, but only its ratio counts.
  const auto energy = [this](const EngineState& s) { return s.angularVelocity.dot(momentum(s)); };
  row.energyDrift = energy(end) / energy(start) - 1;
  row.momentumDrift = momentum(end).norm() / momentum(start).norm() - 1;
  row.halfTurns = countHalfTurns(looks);
  row.chosenSteps = engine->chosenSteps();
  row.nanoseconds = nanosecondsAStep(mode, motion_, step);
  return row;
}

Eigen::Vector3d Comparison::momentum(const EngineState& state) const {
  const Eigen::Matrix3d& rotation = state.worldFromBody;
  return rotation * inertia_.asDiagonal() * rotation.transpose() * state.angularVelocity;
}

int Comparison::countHalfTurns(const std::vector<EngineState>& looks) const {
  Eigen::Index spunAxis = 0;
  motion_.angularVelocity.cwiseAbs().maxCoeff(&spunAxis);
  physics::HalfTurnCounter counter;
  int halfTurns = counter.count(0);
  for (const EngineState& look : looks) {
    const Eigen::Vector3d axis = look.worldFromBody.col(spunAxis);
    const double cosine = axis.dot(momentum(look).normalized());
    const double tilt = std::acos(std::clamp(cosine, -1.0, 1.0));
    halfTurns = counter.count(tilt * 180 / std::numbers::pi);
  }
  return halfTurns;
}

}  // namespace rotatebook::bench
