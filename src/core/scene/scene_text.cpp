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

/// Returns the text of all sections but those of runs, [study] and [map].
std::string clipText(const Scene& scene, Printed printed) {
  const auto sections = motionSections();
  // The panels of a grid follow from it.
  const bool alone = scene.panels.empty() || scene.grid;
  std::string text = linesOf(titleKeys(), scene, printed);
  if (alone) text += textOf(sections.first(2), scene, printed);
  const std::string timePerFrame = timePerFrameLine(scene.simulation, printed);
  if (!alone && !timePerFrame.empty()) text += "\n[simulation]\n";
  text += timePerFrame;
  if (alone) text += textOf(sections.subspan(2, 2), scene, printed);  // [initial] and [[nudge]]
  text += textOf(pictureSections(), scene, printed);
  text += alone ? textOf(sections.last(1), scene, printed) : panelsText(scene.panels, printed);
  return text + gridText(scene, printed);
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
