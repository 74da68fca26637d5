// Prints a Scene as TOML, every key in a fixed order.
#include "scene/scene_text.h"

#include <string>

#include "scene/keys/keys.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

std::string panelsText(const std::vector<Panel>& panels, Printed printed) {
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

/// Returns the text of all sections but those of runs, [study] and [map].
std::string clipText(const Scene& scene, Printed printed) {
  const auto sections = motionSections();
  const Spec spec = explicitSpec(scene);
  const bool alone = spec.panels.empty();
  std::string text = linesOf(titleKeys(), spec, printed);
  if (alone) text += textOf(sections.first(2), spec.motion, printed);
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
  return clipText(scene, Printed::All) + studyText(scene) + mapText(scene, Printed::All);
}

std::string motionText(const Scene& scene) {
  return clipText(scene, Printed::OfMotion);
}

std::string studyRunsText(const Scene& scene) {
  return motionText(scene) + studyText(scene);
}

std::string mapRunsText(Scene scene) {
  for (Axis* axis : {&scene.map->x, &scene.map->y}) axis->label.clear();
  return motionText(scene) + mapText(scene, Printed::OfMotion);
}

}  // namespace rotatebook::scene
