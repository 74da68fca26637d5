// Reports on the rendering of scenes, as text and as JSON. Inside the room only.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/json.h"
#include "pipeline/render_clip.h"
#include "scene/scene.h"
#include "timeline/motion_summary.h"

namespace rotatebook::cli {

/// A scene, and as much of its render's outcome as there is.
struct RenderedScene {
  scene::Scene scene;
  std::optional<pipeline::RenderStart> start{};    ///< Nothing if nothing was to be drawn.
  std::optional<pipeline::RenderResult> result{};  ///< Nothing after an error, too.
  std::vector<timeline::MotionSummary> motions{};  ///< Empty until all are simulated.
  bool interrupted = false;
  std::string error{};      ///< Empty if there was none.
  bool isDetailed = false;  ///< Reports name the renderer and threads.
};

/// Prints the scene's title, and what draws and encodes with how many threads if that is reported.
/// `rendered` must have a start.
void reportStart(const RenderedScene& rendered, const pipeline::RenderOptions& options,
                 std::ostream& out);

/// Prints what was written and kept of a render that didn't fail, and, if it is complete, its
/// motions.
void reportRender(const RenderedScene& rendered, const pipeline::RenderOptions& options,
                  std::ostream& out);

/// Prints the notes on such a render, a line "note: NAME: ..." each: what it replaced, what stays
/// though it was made with other settings, what couldn't be removed, and notes on its motions.
void reportRenderNotes(const RenderedScene& rendered, std::ostream& out);

/// Returns all of it as a JSON object.
Json renderJson(const RenderedScene& rendered, const pipeline::RenderOptions& options);

}  // namespace rotatebook::cli
