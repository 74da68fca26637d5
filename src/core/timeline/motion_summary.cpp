#include "timeline/motion_summary.h"

#include <algorithm>

#include "physics/measure/measurement.h"
#include "scene/expectation_text.h"
#include "timeline/free_pieces.h"
#include "timeline/notes.h"

namespace rotatebook::timeline {

using physics::Sample;

bool MotionSummary::met() const {
  return !divergesUnexpectedly && std::ranges::all_of(expectations, &scene::ExpectationResult::met);
}

std::vector<double> flipsOf(const physics::Trajectory& trajectory) {
  std::vector<double> flips;
  const Sample* before = &trajectory.samples.front();
  for (const Sample& sample : trajectory.samples) {
    if (sample.halfTurns > before->halfTurns) {
      flips.resize(static_cast<std::size_t>(sample.halfTurns), halfTurnTime(*before, sample));
    }
    before = &sample;
  }
  return flips;
}

MotionSummary summarize(const scene::Panel& motion, const physics::Trajectory& trajectory) {
  const std::vector<Sample>& samples = trajectory.samples;
  MotionSummary summary{
      .motion = motion,
      .frames = samples.size(),
      .flips = flipsOf(trajectory),
      .divergedAt = trajectory.divergedAt,
      .divergesUnexpectedly = divergesUnexpectedly(trajectory, motion.expectations),
      .expectations = check(trajectory, motion.expectations)};
  for (const std::span<const Sample> piece : freePieces(trajectory, motion.nudges)) {
    for (const Sample& sample : piece) {
      const double energy = sample.total() / piece.front().total();
      summary.lowestEnergy = std::min(summary.lowestEnergy, energy);
      summary.highestEnergy = std::max(summary.highestEnergy, energy);
    }
  }
  if (motion.simulation.model != physics::Model::Exact) {
    summary.errorDeg = std::ranges::max(samples, {}, &Sample::errorDeg).errorDeg;
    const auto visible = std::ranges::find_if(
        samples, [](const Sample& sample) { return sample.errorDeg > kVisibleErrorDeg; });
    if (visible != samples.end()) summary.visibleFrom = visible->time;
  }
  if (std::string note = regimeNote(trajectory, motion.nudges);
      !note.empty() && !motion.simulation.dissipates()) {
    summary.notes.push_back(std::move(note));
  }
  return summary;
}

std::vector<MotionSummary> summarize(const scene::Scene& scene, const ClipMotion& motion) {
  std::vector<MotionSummary> summaries;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene.motions) {
    summaries.push_back(summarize(panel, *trajectory++));
  }
  return summaries;
}

void leaveUnjudged(std::vector<MotionSummary>& motions) {
  for (MotionSummary& summary : motions) {
    summary.isJudged = false;
    summary.divergesUnexpectedly = false;
    summary.expectations.clear();
  }
}

bool allMet(const std::vector<MotionSummary>& motions) {
  return std::ranges::all_of(motions, &MotionSummary::met);
}

}  // namespace rotatebook::timeline
