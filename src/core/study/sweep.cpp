#include "study/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/layout.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::Sample;
using scene::Quantity;

/// Returns the value of `quantity` of a sample, as far from its reference as it is there.
double departure(const Sample& sample, const Sample& start, Quantity quantity) {
  switch (quantity) {
    case Quantity::TiltDeg:
      return sample.tiltDeg;
    case Quantity::EnergyRatio:
      return std::fabs(sample.total() / start.total() - 1);
    case Quantity::RotationalRatio:
      return std::fabs(sample.rotational / start.total() - 1);
    case Quantity::MomentumRatio:
      return std::fabs(sample.angularMomentum.norm() / start.angularMomentum.norm() - 1);
    case Quantity::Stretch:
      return std::max(std::fabs(sample.stretchMin - 1), std::fabs(sample.stretchMax - 1));
    case Quantity::ErrorDeg:
      return sample.errorDeg;
    case Quantity::CentreDrift:
      return sample.centreDrift();
    case Quantity::HalfTurns:
    case Quantity::Regime:
    case Quantity::DivergesAt:
      break;  // of a motion, not of a sample
  }
  return kNoNumber;
}

SweepRow runOne(const scene::SweepRun& run, const std::vector<Quantity>& measures,
                std::int64_t frames, const Execution& execution) {
  SweepRow row{run.value, run.curve};
  row.length = static_cast<double>(frames - 1) * run.motion.simulation.timePerFrame;
  const auto trajectory = wholeMotion(run.motion, frames, execution.stop, row.end);
  for (const Quantity quantity : measures) {
    double value = kNoNumber;
    if (trajectory) value = reduced(*trajectory, quantity);
    const bool diverged = row.end.kind == RunEnd::Kind::Diverged;
    if (diverged && quantity == Quantity::DivergesAt) value = row.end.time;
    row.measured.push_back(value);
  }
  return row;
}

}  // namespace

double reduced(const physics::Trajectory& trajectory, Quantity quantity) {
  const Sample& start = trajectory.samples.front();
  const Sample& end = trajectory.samples.back();
  if (quantity == Quantity::DivergesAt) {
    return trajectory.divergedAt.value_or(std::numeric_limits<double>::infinity());
  }
  if (quantity == Quantity::HalfTurns) return end.halfTurns;
  if (quantity == Quantity::Regime) return static_cast<double>(end.regime);
  double largest = 0;
  for (const Sample& sample : trajectory.samples) {
    largest = std::max(largest, departure(sample, start, quantity));
  }
  return largest;
}

std::optional<SweepStudy> runSweep(const scene::Scene& scene, const scene::StudySettings& study,
                                   const Execution& execution) {
  requireSameLayout();
  const scene::Sweep& sweep = *study.sweep;
  std::vector<physics::MotionSettings> motions;
  for (const scene::SweepRun& run : sweep.runs) motions.push_back(run.motion);
  SweepStudy result;
  result.rows.resize(sweep.runs.size());
  const auto run = [&](std::size_t i) {
    result.rows[i] = runOne(sweep.runs[i], sweep.measures, scene.clip.frameCount(), execution);
  };
  if (!makeRuns(motions, run, execution)) return std::nullopt;
  return result;
}

std::string ExpectedOfRun::subject() const {
  return std::string(nameOf(expectation.quantity)) + " at " + value +
         (curve.empty() ? "" : ", " + curve);
}

std::vector<ExpectedOfRun> expectedOf(const SweepStudy& result, const scene::Sweep& sweep) {
  std::vector<ExpectedOfRun> all;
  for (const scene::SweepExpectation& one : sweep.expected) {
    const auto measure = std::ranges::find(sweep.measures, one.quantity) - sweep.measures.begin();
    for (const SweepRow& row : result.rows) {
      if (row.value != one.at.value_or(row.value)) continue;
      if (row.curve != one.curve.value_or(row.curve)) continue;
      all.push_back({one, row.value, row.curve, row.measured[static_cast<std::size_t>(measure)]});
    }
  }
  return all;
}

std::string sweepCsv(const SweepStudy& result, const scene::Sweep& sweep) {
  std::string text = sweep.over.key;
  if (sweep.curves) text += "," + sweep.curves->key;
  for (const Quantity quantity : sweep.measures) text += "," + std::string(nameOf(quantity));
  text += ",status\n";
  for (const SweepRow& row : result.rows) {
    text += row.value;
    if (sweep.curves) text += "," + row.curve;
    for (const double value : row.measured) text += field(value);
    text += "," + row.end.text() + "\n";
  }
  return text;
}

}  // namespace rotatebook::study
