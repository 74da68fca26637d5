// Prints a Scene as TOML, every key in a fixed order.
#include "scene/scene_text.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/sections.h"
#include "scene/source_locations.h"

namespace rotatebook::scene {
namespace {

std::string panelsText(const std::vector<Panel>& panels, const Printed& printed) {
  std::string text;
  for (const Panel& panel : panels) {
    text += "\n[[panel]]\n" + linesOf(panelKeys(), panel, printed) +
            textOf(motionSections(), panel, printed, "panel.");
  }
  return text;
}

/// Returns the scene's Spec with every default explicit.
Spec explicitSpec(const Scene& scene) {
  Spec spec = scene;
  spec.camera.position = scene.cameraPosition;
  if (!spec.panels.empty()) {
    spec.panels = scene.motions;
  } else if (!spec.grid) {
    spec.motion = scene.motions.front();
  }
  return spec;
}

bool varies(const Spec& spec, std::string_view key) {
  const auto isIt = [key](const std::optional<Axis>& axis) { return axis && axis->key == key; };
  return (spec.grid && (isIt(spec.grid->columns) || isIt(spec.grid->rows))) ||
         (spec.study && (isIt(spec.study->x) || isIt(spec.study->curves)));
}

/// Returns the keys that must stay out because the scene states none of them, and their defaults
/// depend on one that an axis varies.
std::vector<std::string_view> openKeys(const Spec& spec) {
  std::vector<std::string_view> open;
  for (const auto& [key, of] : kDependentKeys) {
    if (varies(spec, of) && !spec.locations.contains(key))
      open.push_back(key.substr(key.find('.') + 1));
  }
  return open;
}

/// Returns the text of all sections but those of runs, [study] and [map].
std::string clipText(const Scene& scene, const Printed& printed) {
  const auto sections = motionSections();
  const Spec spec = explicitSpec(scene);
  const bool alone = spec.panels.empty();
  std::string text = linesOf(titleKeys(), spec, printed);
  const std::vector<std::string_view> open = openKeys(spec);
  if (alone) text += textOf(sections.first(2), spec.motion, {printed.ofMotion, open});
  if (!spec.clip.speed) {
    if (!alone) text += "\n[simulation]\n";
    text += timePerFrameLine(spec.motion.simulation, printed);
  }
  if (alone) text += textOf(sections.subspan(2, 2), spec.motion, printed);  // [initial], [[nudge]]
  text += textOf(pictureSections(), spec, printed);
  text += alone ? textOf(sections.last(1), spec.motion, printed) : panelsText(spec.panels, printed);
  return text + gridText(spec, printed);
}

}  // namespace

std::string sceneText(const Scene& scene) {
  requireSameLayout();
  return clipText(scene, {}) + studyText(scene) + mapText(scene, {});
}

std::string motionText(const Scene& scene) {
  return clipText(scene, {.ofMotion = true});
}

std::string studyRunsText(const Scene& scene) {
  return motionText(scene) + studyText(scene);
}

std::string mapRunsText(Scene scene) {
  for (Axis* axis : {&scene.map->x, &scene.map->y}) axis->label.clear();
  return motionText(scene) + mapText(scene, {.ofMotion = true});
}

}  // namespace rotatebook::scene
