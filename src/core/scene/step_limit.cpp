// Limits the integration steps that a scene may take.
#include <numeric>
#include <string>

#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

std::int64_t stepsOf(const physics::SimulationSettings& settings) {
  return physics::takesSteps(settings.model) ? settings.substeps : 1;
}

/// Returns the steps of all motions from one frame to the next.
std::int64_t stepsOf(const Scene& scene) {
  std::int64_t steps = 0;
  for (const Panel& panel : motionsOf(scene)) steps += stepsOf(panel.simulation);
  return steps;
}

/// Returns the steps of all runs of a study.
std::int64_t stepsOf(const StudySettings& study, const Scene& scene) {
  const auto sizeOf = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  if (study.sweep) {
    std::int64_t steps = 0;
    for (const auto& [value, curve, motion] : study.sweep->runs) {
      steps += studiedSamples(scene, study, motion) * stepsOf(motion.simulation);
    }
    return steps;
  }
  const std::int64_t samples = studiedSamples(scene, study, studiedMotion(scene, study));
  if (study.isOfTilts()) return samples * sizeOf(study.tilts) * stepsOf(scene.simulation);
  return samples * sizeOf(study.integrators) *
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

/// Returns the frames of `time_per_frame` that a clip takes. Where its speed changes, the steps of
/// up to one more are made for each picture, which may fall between two frames.
std::int64_t framesOf(const Scene& scene) {
  const std::int64_t frames = scene.clip.frameCount();
  if (hasEvenTimes(scene)) return frames;
  const double length = timeAt(scene, static_cast<double>(frames));
  return frames + static_cast<std::int64_t>(length / scene.simulation.timePerFrame);
}

void refuseMany(std::int64_t steps, const std::string& who, const ValueReader& source,
                const std::string& remedy) {
  if (steps <= kMaxSteps) return;
  source.fail(who + " " + std::to_string(steps) + " integration steps; the limit is " +
              std::to_string(kMaxSteps) + " in all: " + remedy);
}

}  // namespace

void checkSteps(const ValueReader& file, const Scene& scene) {
  refuseMany(framesOf(scene) * stepsOf(scene), "the clip takes", statedSubsteps(file),
             "lower simulation.substeps or clip.duration");
  const auto study = file.find("study");
  if (!study) return;
  const bool isOfTilts = scene.study->isOfTilts();
  const auto list = study->find(scene.study->sweep ? "values" : isOfTilts ? "tilts" : "steps");
  refuseMany(stepsOf(*scene.study, scene), "the study takes", list.value_or(*study),
             "make fewer runs, or shorter ones");
}

}  // namespace rotatebook::scene
