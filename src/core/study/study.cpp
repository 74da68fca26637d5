#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/error.h"
#include "base/number_text.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "rigid/inertia.h"
#include "scene/names.h"
#include "scene/source_locations.h"
#include "study/reduced.h"
#include "study/whole_motion.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using physics::Trajectory;
using scene::Measure;

void measure(const Trajectory& trajectory, PrecisionRow& row) {
  row.errorDeg = reduced(trajectory, Measure::ErrorDeg);
  row.finalErrorDeg = trajectory.samples.back().errorDeg;
  row.energyDrift = reduced(trajectory, Measure::EnergyRatio);
  row.momentumDrift = reduced(trajectory, Measure::MomentumRatio);
  row.halfTurns = trajectory.samples.back().halfTurns;
}

MotionSettings withStepping(MotionSettings settings, physics::Integrator integrator, int substeps) {
  settings.simulation.integrator = integrator;
  settings.simulation.substeps = substeps;
  return settings;
}

PrecisionRow runPrecision(const MotionSettings& settings, std::int64_t samples,
                          const Execution& execution) {
  PrecisionRow row;
  row.integrator = settings.simulation.integrator;
  row.h = settings.simulation.timePerFrame / settings.simulation.substeps;
  row.steps = (samples - 1) * settings.simulation.substeps;
  const auto trajectory = wholeMotion(settings, samples, execution.stop, row.end);
  if (!trajectory || isSet(execution.stop)) return row;
  measure(*trajectory, row);
  if (execution.nanosecondsPerStep)
    row.nsPerStep = execution.nanosecondsPerStep(settings, row.steps);
  return row;
}

IntegratorOrder orderOf(physics::Integrator integrator, const std::vector<PrecisionRow>& rows) {
  std::vector<ErrorAtStep> runs;
  for (const PrecisionRow& row : rows) {
    const bool counts = row.integrator == integrator && row.end.kind == RunEnd::Kind::Whole;
    if (counts) runs.push_back({row.h, row.errorDeg});
  }
  return {integrator, fitOrder(runs)};
}

TiltRow runTilt(const MotionSettings& settings, std::int64_t samples, Stop stop) {
  TiltRow row;
  row.tilt = settings.initial.tilt->angle;
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  row.law = physics::asymptoticFlipInterval(inertia, initialAngularVelocity(settings));
  const auto trajectory = wholeMotion(settings, samples, stop, row.end);
  if (!trajectory) return row;
  const std::vector<double> times = flipTimes(*trajectory, inertia);
  row.flips = static_cast<int>(times.size());
  row.interval = physics::meanInterval(times);
  if (times.size() < 2) row.end = {RunEnd::Kind::FewFlips, trajectory->samples.back().time};
  return row;
}

}  // namespace

void requireStudyable(const scene::Scene& scene, const scene::StudySettings& study) {
  requireSameLayout();
  if (!scene.panels.empty()) {
    throw InputError(
        scene::locationOf(scene, "panel") +
        ": a study needs a single motion, but this scene has several, panels or a grid");
  }
  if (!physics::takesSteps(scene.simulation.model)) {
    throw InputError(scene.name + ": the model \"" +
                     std::string(nameOf(scene::kModels, scene.simulation.model)) +
                     "\" takes no steps, so there are no steps to compare; "
                     "choose another model, e.g. --set simulation.model=quaternion");
  }
  if (studiedSamples(scene, study, studiedMotion(scene, study)) < 2) {
    throw InputError(scene.name + ": a single sample has no motion to study; make it longer");
  }
}

double TiltStudy::greatestDeviation() const {
  double greatest = 0;
  for (const TiltRow& row : rows) {
    const double deviation = std::fabs(row.ratio() - 1);
    if (!(deviation <= greatest)) greatest = deviation;
    if (std::isnan(greatest)) break;
  }
  return greatest;
}

std::optional<PrecisionStudy> runPrecisionStudy(const scene::Scene& scene,
                                                const scene::StudySettings& study,
                                                const Execution& execution) {
  requireStudyable(scene, study);
  const MotionSettings motion = studiedMotion(scene, study);
  const std::int64_t samples = studiedSamples(scene, study, motion);
  std::vector<MotionSettings> runs;
  for (const physics::Integrator integrator : study.integrators) {
    for (const int steps : study.steps) {
      runs.push_back(withStepping(motion, integrator, steps));
    }
  }
  PrecisionStudy result;
  result.rows.resize(runs.size());
  const auto run = [&](std::size_t i) {
    result.rows[i] = runPrecision(runs[i], samples, execution);
  };
  if (!makeRuns(runs, run, execution)) return std::nullopt;
  for (const physics::Integrator integrator : study.integrators) {
    result.orders.push_back(orderOf(integrator, result.rows));
  }
  return result;
}

std::optional<TiltStudy> runTiltStudy(const scene::Scene& scene, const scene::StudySettings& study,
                                      const Execution& execution) {
  requireSameLayout();
  const MotionSettings motion = studiedMotion(scene, study);
  const std::int64_t samples = studiedSamples(scene, study, motion);
  std::vector<MotionSettings> runs(study.tilts.size(), motion);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].initial.tilt->angle = study.tilts[i];
  }
  TiltStudy result;
  result.rows.resize(runs.size());
  const auto run = [&](std::size_t i) {
    result.rows[i] = runTilt(runs[i], samples, execution.stop);
  };
  if (!makeRuns(runs, run, execution)) return std::nullopt;
  return result;
}

}  // namespace rotatebook::study
