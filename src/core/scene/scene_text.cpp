// Prints a Scene as TOML, every key in a fixed order.
#include "scene/scene_text.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "scene/keys/keys.h"
#include "scene/sections.h"

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

/// Returns the keys that must stay out because their defaults follow an axis.
std::vector<std::string_view> openKeys(const Spec& spec) {
  std::vector<std::string_view> open;
  const auto add = [&open](const std::optional<Axis>& axis) {
    if (axis) open.insert(open.end(), axis->followers.begin(), axis->followers.end());
  };
  if (spec.grid) add(spec.grid->columns), add(spec.grid->rows);
  if (spec.study) add(spec.study->x), add(spec.study->curves);
  return open;
}

/// Returns the text of all sections but those of runs, [study] and [map].
std::string clipText(const Scene& scene, const Printed& printed) {
  const auto sections = motionSections();
  Spec spec = scene;
  if (!printed.isBrief) spec.camera.position = scene.cameraPosition;
  const bool havePanels = scene.hasPanels() && !scene.grid;
  const Motion& motion = scene.grid ? scene.motion : scene.motions.front();
  std::string text = linesOf(titleKeys(), spec, printed);
  const std::vector<std::string_view> open = openKeys(spec);
  if (!havePanels)
    text += textOf(sections.first(2), motion, {printed.ofMotion, printed.isBrief, open});
  if (!spec.clip.speed) {
    if (havePanels) text += "\n[simulation]\n";
    text += timePerFrameLine(motion.simulation, printed);
  }
  if (!havePanels) text += textOf(sections.subspan(2, 2), motion, printed);  // [initial], [[nudge]]
  if (printed.isBrief && spec.clip.speed == PlaybackSpeed{}) spec.clip.speed.reset();
  text += textOf(pictureSections(), spec, printed);
  text +=
      havePanels ? panelsText(scene.motions, printed) : textOf(sections.last(1), motion, printed);
  return text + gridText(spec, printed);
}

}  // namespace

std::string sceneText(const Scene& scene) {
  requireSameLayout();
  return clipText(scene, {}) + studyText(scene, {}) + mapText(scene, {});
}

std::string briefText(const Scene& scene) {
  constexpr Printed kBrief{.isBrief = true};
  const std::string whole = sceneText(scene);
  const std::string text =
      clipText(scene, kBrief) + studyText(scene, kBrief) + mapText(scene, kBrief);
  // Only the whole text may say the same if a default follows from other keys.
  try {
    return sceneText(parseScene(text, scene.name + ".toml")) == whole ? text : whole;
  } catch (const InputError&) {
    return whole;
  }
}

std::string motionText(const Scene& scene) {
  return clipText(scene, {.ofMotion = true});
}

std::string studyRunsText(const Scene& scene) {
  return motionText(scene) + studyText(scene, {});
}

std::string mapRunsText(Scene scene) {
  for (Axis* axis : {&scene.map->x, &scene.map->y}) axis->label.clear();
  return motionText(scene) + mapText(scene, {.ofMotion = true});
}

}  // namespace rotatebook::scene
