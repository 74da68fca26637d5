// The times at which a clip shows its motion, from its cues and speeds. Inside the room only.
#pragma once

#include "scene/scene.h"

namespace rotatebook::scene {

/// Returns the longest motion that the scene's clip may show, whatever moments its speeds and cues
/// name. [s]
double longestMotion(const Scene& scene);

/// Finds Scene::schedule and Scene::shownCues, whose events it finds by simulating a motion as far
/// as they are: at the even times of a clip without cues and stretches, so that no event depends on
/// what is found. Does nothing to a scene whose motions, with events that it names, aren't there
/// yet. Throws DocumentError for an event that the motion doesn't have, for stretches of speed that
/// overlap, and for two cues in one frame.
void schedule(Scene& scene);

}  // namespace rotatebook::scene
