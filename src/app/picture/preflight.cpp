#include "picture/preflight.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/text.h"
#include "picture/composition.h"
#include "scene/overlays.h"
#include "timeline/notes.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {

namespace {

/// Returns sentences on the overlays for which the scene's pictures have no room, and on cues of
/// more lines than are read at a glance.
std::vector<std::string> notesOnText(const scene::Scene& scene) {
  // A clip of one frame has the text of the whole clip.
  scene::Scene first = scene;
  first.clip.duration = scene.clip.frameRate.period();
  const timeline::ClipMotion motion = timeline::simulateScene(first);
  const Composition composition(first, motion);
  std::vector<std::string> names;
  for (const scene::Overlay overlay : composition.leftOut())
    names.push_back(quotedText(scene::rowOf(overlay).name));
  std::vector<std::string> notes;
  for (const std::size_t cue : composition.longCues()) {
    notes.push_back(fmt::format(
        "cue.{}.text takes more than two lines, which few read in time; shorten it", cue));
  }
  if (names.empty()) return notes;
  const char* them = names.size() == 1 ? "it" : "them";
  const char* have = scene.grid          ? "cells have"
                     : scene.hasPanels() ? "panels have"
                                         : "a picture has";
  notes.push_back(fmt::format(
      "overlay.show has {}, for which {} no room in {} pixels; make the picture larger, or leave "
      "{} out",
      listed(names), have, sizeText(scene.clip.width, scene.clip.height), them));
  return notes;
}

}  // namespace

std::vector<std::string> notesOn(const scene::Scene& scene) {
  std::vector<std::string> notes = timeline::notesOn(scene);
  const std::vector<std::string> ofText = notesOnText(scene);
  notes.insert(notes.end(), ofText.begin(), ofText.end());
  return notes;
}

Preflight preflight(const scene::Scene& scene) {
  TextureFiles textures = readTextures(scene);
  return {std::move(textures), notesOn(scene)};
}

}  // namespace rotatebook::picture
