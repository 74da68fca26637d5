// Rendering scenes, with words on what goes on and what came of it. Inside the room only.
#pragma once

#include <vector>

#include "pipeline/render_clip.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// How many scenes to render at a time on a machine with so many cores, three of which a render
/// keeps busy, and so much memory [bytes], a quarter of which they may take together. At least 1.
int scenesAtATime(const std::vector<scene::Scene>& scenes, int cores, double memory);

/// Renders all scenes, `atATime` of them at a time, and reports each on the standard output, in
/// their order. `options.stop` must not be null. Returns the worst status, or that of an interrupt,
/// after which no more scenes are begun. Throws the first error of any scene, after which none are
/// begun either; those that go on meanwhile are brought to their end.
int renderScenes(const std::vector<scene::Scene>& scenes, const pipeline::RenderOptions& options,
                 int atATime);

}  // namespace rotatebook::cli
