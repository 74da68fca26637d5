#include "scene/resolve.h"

#include <algorithm>
#include <utility>

#include "base/document/problems.h"
#include "scene/sections.h"
#include "scene/settled_motion.h"

namespace rotatebook::scene {
namespace {

/// Gives a motion that doesn't state its own the clip's clock.
void setClock(const ClipSettings& clip, physics::SimulationSettings& simulation) {
  if (!clip.speed) return;
  simulation.timePerFrame = clip.frameRate.period() * clip.speed->constant;
  simulation.substepped = kSubstepped;
}

void settleMotions(Scene& scene, Shared& shared) {
  document::Problems problems;
  for (Panel& motion : scene.motions) {
    setClock(scene.clip, motion.simulation);
    problems.note([&] { settle(shared, motion); });
  }
  problems.throwIfAny();
  if (scene.grid) checkCells(scene);
}

void settleRuns(Scene& scene, Shared& shared) {
  const bool haveOwnClocks = scene.study->varies("simulation.time_per_frame");
  document::Problems problems;
  for (StudyRun& run : scene.runs) {
    if (!haveOwnClocks) setClock(scene.clip, run.motion.simulation);
    sampleAsAsked(*scene.study, run.motion);
    problems.note([&] { settle(shared, run.motion); });
  }
  problems.throwIfAny();
  checkRuns(scene);
}

/// Returns the default camera position, from which the largest of the bodies is seen whole.
Eigen::Vector3d defaultPosition(const Scene& scene) {
  const double angle = scene.camera.fieldOfViewDeg;
  const auto diagonal = [](const Panel& panel) { return panel.body.size.norm(); };
  const Panel& largest = *std::ranges::max_element(scene.motions, {}, diagonal);
  // In panels the angle is over the shorter side, so their shape doesn't matter
  if (scene.hasPanels()) return defaultCameraPosition(largest.body, angle, 1, 1);
  return defaultCameraPosition(largest.body, angle, scene.clip.width, scene.clip.height);
}

}  // namespace

Scene resolve(Spec spec, const MeshFiles& meshes) {
  Scene scene;
  static_cast<Spec&>(scene) = std::move(spec);
  Shared shared{meshes};
  settleMotions(scene, shared);
  scene.cameraPosition = scene.camera.position.value_or(defaultPosition(scene));
  document::Problems problems;
  problems.note([&] { checkCamera(scene); });
  problems.note([&] { checkMoves(scene); });
  problems.note([&] { checkOverlays(scene); });
  if (scene.study) problems.note([&] { settleRuns(scene, shared); });
  if (scene.map) problems.note([&] { checkMap(scene); });
  problems.throwIfAny();
  checkSteps(scene);
  return scene;
}

}  // namespace rotatebook::scene
