#include "timeline/verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "physics/simulate.h"
#include "timeline/motion_summary.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;

double angleDegBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return arcTangent(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// Takes the one of two drifts that is larger, whatever its sign.
void takeLarger(double drift, double& largest) {
  if (std::fabs(drift) > std::fabs(largest)) largest = drift;
}

/// Returns the largest change of the angular velocity in the world, relative to the start's.
double spinChange(const std::vector<Sample>& samples) {
  const Eigen::Vector3d& start = samples.front().angularVelocity;
  double largest = 0;
  for (const Sample& sample : samples) {
    largest = std::max(largest, (sample.angularVelocity - start).norm() / start.norm());
  }
  return largest;
}

physics::Trajectory exactAt(physics::MotionSettings motion, const std::vector<Sample>& samples) {
  std::vector<double> times;
  for (const Sample& sample : samples) times.push_back(sample.time);
  motion.simulation.model = physics::Model::Exact;
  return physics::simulate(motion, times);
}

Errs errsOf(const Verdict& verdict, const std::vector<Sample>& samples,
            const std::vector<Sample>& exact) {
  if (verdict.errorDeg < kAgreesDeg) return Errs::Hardly;
  // A spin that the exact motion keeps, too, tells nothing.
  constexpr double kMoves = 0.02;
  if (spinChange(samples) < kKept && spinChange(exact) > kMoves) return Errs::SpinIsFixed;
  const double energy = verdict.endEnergyDrift, momentum = verdict.endMomentumDrift;
  const bool keepsEnergy = std::fabs(verdict.energyDrift) < kKept;
  const bool keepsMomentum = std::fabs(verdict.momentumDrift) < kKept;
  if (keepsEnergy && keepsMomentum) return Errs::InPhase;
  if (keepsMomentum) return energy > 0 ? Errs::GainsEnergy : Errs::LosesEnergy;
  if (energy > 0) return Errs::GainsBoth;
  return momentum > 0 ? Errs::Inconsistently : Errs::LosesBoth;
}

}  // namespace

Verdict judge(const physics::MotionSettings& motion, const physics::Trajectory& trajectory) {
  const std::vector<Sample>& samples = trajectory.samples;
  const Sample &first = samples.front(), &last = samples.back();
  const auto energyDrift = [&](const Sample& one) { return one.total() / first.total() - 1; };
  const auto momentumDrift = [&](const Sample& one) {
    return one.angularMomentum.norm() / first.angularMomentum.norm() - 1;
  };
  Verdict verdict;
  verdict.samples = samples.size();
  verdict.duration = last.time;
  for (const Sample& sample : samples) {
    verdict.errorDeg = std::max(verdict.errorDeg, sample.errorDeg);
    if (!verdict.visibleFrom && sample.errorDeg > kVisibleErrorDeg) {
      verdict.visibleFrom = sample.time;
    }
    takeLarger(energyDrift(sample), verdict.energyDrift);
    takeLarger(momentumDrift(sample), verdict.momentumDrift);
    verdict.momentumTurnDeg = std::max(
        verdict.momentumTurnDeg, angleDegBetween(sample.angularMomentum, first.angularMomentum));
  }
  verdict.endErrorDeg = last.errorDeg;
  verdict.endEnergyDrift = energyDrift(last);
  verdict.endMomentumDrift = momentumDrift(last);
  verdict.halfTurns = last.halfTurns;
  verdict.start = first.regime;
  verdict.end = last.regime;
  const physics::Trajectory exact = exactAt(motion, samples);
  verdict.halfTurnsDue = exact.samples.back().halfTurns;
  verdict.errs = errsOf(verdict, samples, exact.samples);
  return verdict;
}

std::string methodThat(Errs errs) {
  switch (errs) {
    case Errs::Hardly:
      return "agrees with the exact motion";
    case Errs::SpinIsFixed:
      return "keeps the angular velocity fixed in the world, as without a gyroscopic torque";
    case Errs::InPhase:
      return "keeps energy and angular momentum, but not the pace, as with long steps";
    case Errs::GainsEnergy:
      return "keeps the angular momentum and gains energy, as explicit steps of the attitude do";
    case Errs::LosesEnergy:
      return "keeps the angular momentum and loses energy, as implicit steps do, or damping inside";
    case Errs::GainsBoth:
      return "gains energy, as with an explicit gyroscopic torque of order 1";
    case Errs::LosesBoth:
      return "loses energy and angular momentum, as with an implicit gyroscopic torque, or damping";
    case Errs::Inconsistently:
      return "loses energy while the angular momentum grows, as with a gyroscopic torque of order "
             "1 "
             "that doesn't fit the attitude's step";
  }
  return "";
}

}  // namespace rotatebook::timeline
