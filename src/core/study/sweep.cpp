#include "study/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/layout.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using scene::Measure;

SweepRow runOne(const scene::SweepRun& run, const std::vector<Measure>& measures,
                std::int64_t samples, const Execution& execution) {
  SweepRow row{run.value, run.curve};
  row.length = static_cast<double>(samples - 1) * run.motion.simulation.timePerFrame;
  const auto trajectory = wholeMotion(run.motion, samples, execution.stop, row.end);
  for (const Measure measure : measures) {
    double value = kNoNumber;
    if (trajectory) value = reduced(*trajectory, measure);
    const bool diverged = row.end.kind == RunEnd::Kind::Diverged;
    if (diverged && measure == Measure::DivergesAt) value = row.end.time;
    row.measured.push_back(value);
  }
  return row;
}

}  // namespace

std::optional<SweepStudy> runSweep(const scene::Scene& scene, const scene::StudySettings& study,
                                   const Execution& execution) {
  requireSameLayout();
  const scene::Sweep& sweep = *study.sweep;
  std::vector<physics::MotionSettings> motions;
  for (const scene::SweepRun& run : sweep.runs) motions.push_back(run.motion);
  SweepStudy result;
  result.rows.resize(sweep.runs.size());
  const auto run = [&](std::size_t i) {
    const scene::SweepRun& one = sweep.runs[i];
    const std::int64_t samples = studiedSamples(scene, study, one.motion);
    result.rows[i] = runOne(one, sweep.measures, samples, execution);
  };
  if (!makeRuns(motions, run, execution)) return std::nullopt;
  return result;
}

std::string ExpectedOfRun::subject() const {
  return std::string(nameOf(expectation.measure)) + " at " + value +
         (curve.empty() ? "" : ", " + curve);
}

std::vector<ExpectedOfRun> expectedOf(const SweepStudy& result, const scene::Sweep& sweep) {
  std::vector<ExpectedOfRun> all;
  for (const scene::Expectation& one : sweep.expected) {
    const auto measure = std::ranges::find(sweep.measures, one.measure) - sweep.measures.begin();
    for (const SweepRow& row : result.rows) {
      if (row.value != one.at[0].value_or(row.value)) continue;
      if (row.curve != one.at[1].value_or(row.curve)) continue;
      all.push_back({one, row.value, row.curve, row.measured[static_cast<std::size_t>(measure)]});
    }
  }
  return all;
}

}  // namespace rotatebook::study
