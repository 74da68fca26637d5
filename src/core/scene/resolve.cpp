#include "scene/resolve.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/document/problems.h"
#include "scene/sections.h"
#include "scene/settled_motion.h"

namespace rotatebook::scene {
namespace {

std::vector<Panel> settledPanels(const Spec& spec, const ValueReader& file, Shared& shared) {
  const std::vector<document::TomlNode> merged = mergedPanels(*file.find("panel"), file);
  std::vector<Panel> panels = spec.panels;
  document::Problems problems;
  for (std::size_t i = 0; i < panels.size(); ++i)
    problems.note([&] { settle(ValueReader(merged[i], ""), shared, panels[i]); });
  problems.throwIfAny();
  return panels;
}

std::vector<Panel> settledMotions(const Spec& spec, const ValueReader& file, Shared& shared) {
  if (spec.grid) return cellsOf(spec, file, shared);
  if (!spec.panels.empty()) return settledPanels(spec, file, shared);
  Panel single{{spec.motion}, ""};
  settle(file, shared, single);
  return {single};
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

Scene resolve(Spec spec, const ValueReader& file, const MeshFiles& meshes) {
  Scene scene;
  static_cast<Spec&>(scene) = std::move(spec);
  Shared shared = sharedOf(scene, meshes);
  document::Problems problems;
  problems.note([&] { scene.motions = settledMotions(scene, file, shared); });
  problems.throwIfAny();
  scene.cameraPosition = scene.camera.position.value_or(defaultPosition(scene));
  if (const auto camera = file.find("camera")) problems.note([&] { checkCamera(*camera, scene); });
  if (const auto overlay = file.find("overlay"))
    problems.note([&] { checkOverlays(*overlay, scene); });
  if (scene.study) problems.note([&] { scene.runs = runsOf(scene, file, shared); });
  if (scene.map) problems.note([&] { checkMap(*file.find("map"), scene); });
  problems.throwIfAny();
  checkSteps(file, scene);
  return scene;
}

}  // namespace rotatebook::scene
