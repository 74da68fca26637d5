// Limits the integration steps that a scene may take.
#include <numeric>
#include <string>

#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

std::int64_t stepsOf(const physics::SimulationSettings& settings) {
  return settings.model == physics::Model::Exact ? 1 : settings.substeps;
}

/// Returns the steps of all motions from one frame to the next.
std::int64_t stepsOf(const Scene& scene) {
  std::int64_t steps = 0;
  for (const Panel& panel : motionsOf(scene)) steps += stepsOf(panel.simulation);
  return steps;
}

/// Returns the steps of all runs of a study from one frame to the next.
std::int64_t stepsOf(const StudySettings& study, const Scene& scene) {
  const auto sizeOf = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  if (study.sweep) {
    return std::accumulate(
        study.sweep->runs.begin(), study.sweep->runs.end(), std::int64_t{0},
        [](std::int64_t sum, const SweepRun& run) { return sum + stepsOf(run.motion.simulation); });
  }
  if (study.isOfTilts()) return sizeOf(study.tilts) * stepsOf(scene.simulation);
  return sizeOf(study.integrators) *
         std::accumulate(study.steps.begin(), study.steps.end(), std::int64_t{0});
}

/// Returns the value of a stated `substeps`. Too many steps aren't the default, so some section
/// states them.
ValueReader statedSubsteps(const ValueReader& file) {
  if (const auto common = file.find("simulation", "substeps")) return *common;
  if (const auto panels = file.find("panel")) {
    for (const ValueReader& panel : panels->tables("panels")) {
      if (const auto own = panel.find("simulation", "substeps")) return *own;
    }
  }
  return file;
}

void refuseMany(std::int64_t stepsPerFrame, const Scene& scene, const ValueReader& source,
                const std::string& remedy) {
  const std::int64_t frames = scene.clip.frameCount();
  if (stepsPerFrame <= kMaxSteps / frames) return;
  source.fail(std::to_string(frames) + " frames of " + std::to_string(stepsPerFrame) +
              " integration steps are " + std::to_string(stepsPerFrame * frames) +
              "; the limit is " + std::to_string(kMaxSteps) + " in all: " + remedy);
}

}  // namespace

void checkSteps(const ValueReader& file, const Scene& scene) {
  refuseMany(stepsOf(scene), scene, statedSubsteps(file),
             "lower simulation.substeps or clip.duration");
  const auto study = file.find("study");
  if (!study) return;
  const bool isOfTilts = scene.study->isOfTilts();
  const auto list = study->find(scene.study->sweep ? "values" : isOfTilts ? "tilts" : "steps");
  refuseMany(stepsOf(*scene.study, scene), scene, list.value_or(*study),
             "make fewer runs, or lower clip.duration");
}

}  // namespace rotatebook::scene
