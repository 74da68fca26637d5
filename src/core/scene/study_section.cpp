// Reads and prints [study].
#include <algorithm>
#include <iterator>

#include "document/problems.h"
#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using physics::Model;

constexpr int kMaxDoublings = 10;
// Sine of the largest angle between the untilted spin and the median axis for which there is a law
// to compare with.
constexpr double kMaxSineToMedian = 0.1;

void refuseStepless(const ValueReader& section, Model model) {
  section.fail(
      "the model " + tomlString(nameOf(kModels, model)) +
      " takes no steps, so [study] has no integrators and steps to compare; " +
      (model == Model::Exact ? "give it tilts, or choose another model" : "choose another model"));
}

void checkTilted(const ValueReader& tilts, const Scene& scene) {
  if (scene.simulation.model == Model::Recorded) refuseStepless(tilts, Model::Recorded);
  if (!scene.initial.tilt) {
    tilts.fail(tilts.name() + " needs initial.tilt, whose axis it takes, such as [0.1, \"z\"]");
  }
  physics::MotionSettings motion = scene.motion();
  motion.initial.tilt.reset();
  const Eigen::Vector3d axis = physics::medianAxis(modelInertia(motion));
  const Eigen::Vector3d spin = initialAngularVelocity(motion);
  if (axis.cross(spin).norm() <= kMaxSineToMedian * spin.norm()) return;
  tilts.fail(tilts.name() +
             " needs a spin about the axis of the middle moment of inertia, the only one about "
             "which a body flips");
}

void refuseTiltsWithSteps(const ValueReader& section) {
  for (const char* key : {"integrators", "steps", "orders"}) {
    if (const auto value = section.find(key)) {
      value->fail("[study] has both tilts and " + std::string(key) +
                  "; it compares either tilts, or integrators and steps");
    }
  }
}

/// Throws InputError if the study takes too many samples of a motion.
void checkSamples(const ValueReader& section, const Scene& scene,
                  const physics::MotionSettings& motion) {
  const std::int64_t samples = studiedSamples(scene, *scene.study, motion);
  if (samples <= kMaxFrames) return;
  section.find(scene.study->duration ? "duration" : "interval")
      ->fail("the study takes " + std::to_string(samples) + " samples of a motion; the limit is " +
             std::to_string(kMaxFrames) + ": lower study.duration, or raise study.interval");
}

void refuseWithoutX(const ValueReader& section) {
  for (const Key<Scene>& key : sweepKeys()) {
    if (const auto value = section.find(key.name)) value->fail(value->name() + " needs study.x");
  }
}

}  // namespace

StudySettings defaultStudy(Model model) {
  StudySettings study;
  const auto integrators = integratorsOf(model);
  study.integrators.assign(integrators.begin(), integrators.end());
  if (study.integrators.empty()) return study;
  for (int doublings = 0; doublings <= kMaxDoublings; ++doublings) {
    study.steps.push_back(1 << doublings);
  }
  return study;
}

void readStudy(const ValueReader& section, const ValueReader& file, Scene& scene) {
  if (!scene.panels.empty()) {
    section.fail("[study] needs a single motion, but this scene has several, panels or a grid");
  }
  Keys<Scene> keys = studyKeys();
  std::ranges::copy(samplingKeys(), std::back_inserter(keys));
  const auto ignore = [](const auto&, const ValueReader&) {};
  auto fields = fieldsOf(keys, ignore);
  std::ranges::move(fieldsOf(sweepKeys(), ignore), std::back_inserter(fields));
  section.readTable(fields);
  if (section.find("x")) {
    readSweep(section, file, scene);
    for (const SweepRun& run : scene.study->sweep->runs) checkSamples(section, scene, run.motion);
    return;
  }
  refuseWithoutX(section);
  const auto tilts = section.find("tilts");
  if (tilts) {
    refuseTiltsWithSteps(section);
    scene.study.emplace();
  } else {
    if (const auto law = section.find("flip_law")) law->fail(law->name() + " needs study.tilts");
    if (!takesSteps(scene.simulation.model)) refuseStepless(section, scene.simulation.model);
    scene.study = defaultStudy(scene.simulation.model);
  }
  // In the order of the keys, because the orders depend on the integrators.
  document::Problems problems;
  for (const Key<Scene>& key : keys) {
    const auto value = section.find(key.name);
    if (value) problems.note([&] { key.read(*value, scene); });
  }
  problems.throwIfAny();
  checkSamples(section, scene, studiedMotion(scene, *scene.study));
  if (tilts) checkTilted(*tilts, scene);
}

std::string studyText(const Scene& scene) {
  if (!scene.study) return "";
  return "\n[study]\n" + linesOf(studyKeys(), scene) + ordersText(*scene.study) +
         (scene.study->sweep ? linesOf(sweepKeys(), scene) : "") + linesOf(samplingKeys(), scene);
}

}  // namespace rotatebook::scene
