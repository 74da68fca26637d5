#include "picture/preflight.h"

#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/text.h"
#include "picture/composition.h"
#include "scene/overlays.h"
#include "timeline/notes.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {

namespace {

/// Returns a sentence on the overlays for which the scene's pictures have no room; empty without.
std::string noteOnRoom(const scene::Scene& scene) {
  // A clip of one frame has the text of the whole clip.
  scene::Scene first = scene;
  first.clip.duration = scene.clip.frameRate.period();
  const timeline::ClipMotion motion = timeline::simulateScene(first);
  const Composition composition(first, motion);
  std::vector<std::string> names;
  for (const scene::Overlay overlay : composition.leftOut())
    names.push_back(quotedText(scene::rowOf(overlay).name));
  if (names.empty()) return "";
  const char* them = names.size() == 1 ? "it" : "them";
  const char* have = scene.grid          ? "cells have"
                     : scene.hasPanels() ? "panels have"
                                         : "a picture has";
  return fmt::format(
      "overlay.show has {}, for which {} no room in {} pixels; make the picture larger, or leave "
      "{} out",
      listed(names), have, sizeText(scene.clip.width, scene.clip.height), them);
}

}  // namespace

TextureFiles preflight(const scene::Scene& scene) {
  TextureFiles files = readTextures(scene);
  requireText(scene);
  return files;
}

void requireText(const scene::Scene& scene) {
  noteOnRoom(scene);
}

std::vector<std::string> notesOn(const scene::Scene& scene) {
  std::vector<std::string> notes = timeline::notesOn(scene);
  const std::string room = noteOnRoom(scene);
  if (!room.empty()) notes.push_back(room);
  return notes;
}

}  // namespace rotatebook::picture
