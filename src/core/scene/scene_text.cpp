// Prints a Scene as TOML, every key in a fixed order.
#include "scene/scene_text.h"

#include <string>

#include "scene/keys/keys.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

std::string panelsText(const std::vector<Panel>& panels) {
  std::string text;
  for (const Panel& panel : panels) {
    text +=
        "\n[[panel]]\n" + linesOf(panelKeys(), panel) + textOf(motionSections(), panel, "panel.");
  }
  return text;
}

}  // namespace

std::string sceneText(const Scene& scene) {
  requireSameLayout();
  const auto sections = motionSections();
  // The panels of a grid follow from it.
  const bool alone = scene.panels.empty() || scene.grid;
  std::string text = linesOf(titleKeys(), scene);
  if (alone) text += textOf(sections.first(2), scene);
  const std::string timePerFrame = timePerFrameLine(scene.simulation);
  if (!alone && !timePerFrame.empty()) text += "\n[simulation]\n";
  text += timePerFrame;
  if (alone) text += textOf(sections.subspan(2, 2), scene);  // [initial] and [[nudge]]
  text += textOf(pictureSections(), scene);
  text += alone ? textOf(sections.last(1), scene) : panelsText(scene.panels);
  return text + gridText(scene) + studyText(scene) + mapText(scene);
}

}  // namespace rotatebook::scene
