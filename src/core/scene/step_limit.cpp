#include "scene/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "physics/motion_start.h"
#include "scene/names.h"
#include "scene/schedule.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

/// The samples of a motion.
struct Sampling {
  double count;   // >= 1
  double length;  // of the whole motion [s]
  bool isEven;    // one follows the other at the same interval
};

Sampling samplingOf(const Scene& scene) {
  const auto frames = static_cast<double>(scene.clip.frameCount());
  return {frames, longestMotion(scene), hasEvenTimes(scene) && scene.cues.empty()};
}

/// Returns the steps of a motion. For a sample between two runs of EqualSteps, as much as another
/// run is made.
double stepsOf(const physics::SimulationSettings& settings, const Sampling& sampling) {
  if (!physics::takesSteps(settings.model)) return sampling.count;
  constexpr double kRounding = 1e-9;
  const auto [time, count] = settings.steps();
  const double runs = std::floor(sampling.length / time * (1 + kRounding));
  const double each = sampling.length / time / sampling.count;
  const bool areAtEnds =
      sampling.isEven && each > 0.5 && std::fabs(each - std::round(each)) <= kRounding * each;
  return (areAtEnds ? runs : runs + sampling.count) * count;
}

/// Returns the steps of all motions of the clip.
double stepsOf(const Scene& scene) {
  const Sampling sampling = samplingOf(scene);
  double steps = 0;
  for (const Panel& panel : scene.motions) steps += stepsOf(panel.simulation, sampling);
  return steps;
}

/// Returns the steps of all runs of the scene's study.
double stepsOfRuns(const Scene& scene) {
  double steps = 0;
  for (const auto& [value, curve, motion] : scene.runs) {
    const auto samples = static_cast<double>(studiedSamples(scene, *scene.study, motion));
    steps += stepsOf(motion.simulation, {samples, samples * motion.simulation.timePerFrame, true});
  }
  return steps;
}

/// Returns the location of what states so many steps: of the steps, or else of the clip's speed, as
/// the defaults aren't too many.
std::string sourceOfSteps(const Scene& scene) {
  std::vector<std::string> keys;
  const auto add = [&keys](const std::string& section) {
    for (const std::string_view key : kStepKeys) keys.push_back(section + std::string(key));
  };
  add("simulation.");
  for (std::size_t i = 0; i < scene.motions.size(); ++i)
    add("panel." + std::to_string(i) + ".simulation.");
  keys.push_back("clip.speed");
  return scene.locations.of(keys);
}

void refuseMany(double steps, const std::string& who, const std::string& source,
                const std::string& remedy) {
  if (steps <= kMaxSteps) return;
  constexpr double kMany = 1e18;
  document::failAt(source, who + " " +
                               std::to_string(static_cast<std::int64_t>(std::min(steps, kMany))) +
                               " integration steps; the limit is " + std::to_string(kMaxSteps) +
                               " in all: " + remedy);
}

}  // namespace

std::string shorterSteps(const physics::SimulationSettings& simulation, double longest) {
  if (simulation.step) return "a shorter simulation.step, or ";
  const double enough = std::ceil(simulation.steps().time / longest);
  if (enough > kMaxSubsteps) return "";
  return "simulation.substeps = " + std::to_string(std::llround(enough)) + " or more, or ";
}

void requireSlowSink(const Motion& motion) {
  const double rate = physics::fastestDissipation(motion);
  const double step = motion.simulation.steps().length();
  if (!(rate * step > 1)) return;
  constexpr double kRounding = 0.995;  // of three digits
  const double most = kRounding * motion.simulation.dissipation / (rate * step);
  document::failAt(motion.locations.of({"simulation.dissipation"}),
                   "simulation.dissipation = " + shortestText(motion.simulation.dissipation) +
                       " takes the energy in less than a step of " + roundedText(1e3 * step, 3) +
                       " ms; take " + shorterSteps(motion.simulation, 1 / rate) + "at most " +
                       roundedText(most, 3));
}

void checkSteps(const Scene& scene) {
  refuseMany(stepsOf(scene), "the clip takes", sourceOfSteps(scene),
             "lower simulation.substeps or clip.duration, or state a longer simulation.step");
  refuseMany(stepsOfRuns(scene), "the study takes", scene.locations.of({"study.x", "study"}),
             "make fewer runs, or shorter ones");
}

}  // namespace rotatebook::scene
