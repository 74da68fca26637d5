#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/layout.h"
#include "scene/names.h"
#include "study/reduced.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using scene::Measure;
using scene::StudySettings;

StudyRow runOne(const scene::StudyRun& run, const StudySettings& study, std::int64_t samples,
                const Execution& execution) {
  const MotionSettings& motion = run.motion;
  StudyRow row{run.value, run.curve};
  row.length = static_cast<double>(samples - 1) * motion.simulation.timePerFrame;
  row.step = motion.simulation.steps().length();
  const auto trajectory = wholeMotion(motion, samples, execution.stop, row.end);
  for (const Measure measure : study.measures) {
    double value = trajectory ? reduced(*trajectory, motion, measure) : kNoNumber;
    const bool diverged = row.end.kind == RunEnd::Kind::Diverged;
    if (diverged && measure == Measure::DivergesAt) value = row.end.time;
    row.measured.push_back(value);
  }
  const bool isTimed = execution.nanosecondsPerStep && placeOf(Measure::Order, study);
  if (isTimed && trajectory && !isSet(execution.stop))
    row.nsPerStep = execution.nanosecondsPerStep(motion, scene::studiedSteps(motion, samples));
  return row;
}

CurveOrder orderOf(const std::string& curve, std::size_t place, const std::vector<StudyRow>& rows) {
  std::vector<ErrorAtStep> runs;
  for (const StudyRow& row : rows) {
    const bool counts = row.curve == curve && row.end.kind == RunEnd::Kind::Whole;
    if (counts) runs.push_back({row.step, row.measured[place]});
  }
  return {curve, fitOrder(runs)};
}

std::vector<CurveOrder> ordersOf(const std::vector<StudyRow>& rows, const StudySettings& study) {
  const auto place = placeOf(Measure::Order, study);
  std::vector<CurveOrder> orders;
  if (!place) return orders;
  for (const StudyRow& row : rows) {
    if (orders.empty() || orders.back().curve != row.curve)
      orders.push_back(orderOf(row.curve, *place, rows));
  }
  return orders;
}

}  // namespace

std::optional<std::size_t> placeOf(Measure measure, const StudySettings& study) {
  const auto found = std::ranges::find(study.measures, measure);
  if (found == study.measures.end()) return std::nullopt;
  return static_cast<std::size_t>(found - study.measures.begin());
}

std::optional<Study> runStudy(const scene::Scene& scene, const Execution& execution) {
  requireSameLayout();
  const StudySettings& study = *scene.study;
  std::vector<MotionSettings> motions;
  for (const scene::StudyRun& run : scene.runs) motions.push_back(run.motion);
  Study result;
  result.rows.resize(scene.runs.size());
  const auto run = [&](std::size_t i) {
    const std::int64_t samples = studiedSamples(scene, study, motions[i]);
    result.rows[i] = runOne(scene.runs[i], study, samples, execution);
  };
  if (!makeRuns(motions, run, execution)) return std::nullopt;
  result.orders = ordersOf(result.rows, study);
  return result;
}

std::string StudyExpectation::subject() const {
  const std::string name(nameOf(expectation.measure));
  if (!value.empty()) return name + " at " + value + (curve.empty() ? "" : ", " + curve);
  return name + (curve.empty() ? "" : " of " + curve);
}

std::vector<StudyExpectation> expectedOf(const Study& result, const StudySettings& study) {
  std::vector<StudyExpectation> all;
  for (const scene::Expectation& one : study.expected) {
    const auto isMeant = [&](const std::string& curve) {
      return curve == one.at[1].value_or(curve);
    };
    if (one.measure == Measure::Order) {
      for (const auto& [curve, fit] : result.orders)
        if (isMeant(curve)) all.push_back({one, "", curve, fit.order});
      continue;
    }
    const std::size_t place = *placeOf(one.measure, study);
    for (const StudyRow& row : result.rows) {
      if (row.value != one.at[0].value_or(row.value) || !isMeant(row.curve)) continue;
      all.push_back({one, row.value, row.curve, row.measured[place]});
    }
  }
  return all;
}

}  // namespace rotatebook::study
