// Rendering of scenes, with progress and reports, and of a clip again from its own record. Inside
// the room only.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/device_options.h"
#include "picture/preflight.h"
#include "pipeline/render_clip.h"
#include "scene/scene.h"
#include "store/clip_record.h"
#include "store/clip_settings.h"

namespace rotatebook::cli {

/// A scene, and what was found before any work.
struct SceneToRender {
  scene::Scene scene;
  picture::Preflight found{};
  bool isJudged = true;  ///< True if its expectations are judged.
};

/// The way in which renders are reported.
struct ReportStyle {
  bool json = false;
  bool isDetailed = false;  ///< RenderedScene::isDetailed
};

/// Renders all scenes, `atATime` of them at a time, and reports each on the standard output, in
/// their order, or all as one JSON object: reportBatch(). `options.stop` must not be null. Returns
/// the worst status. After an interrupt it starts no more scenes and returns the interrupt's
/// status. After a scene's error it starts none either, completes those that are running, and
/// throws the first error or, of scenes rendered at the same time, reports the errors and returns
/// the highest of their statuses.
int renderScenes(const std::vector<SceneToRender>& scenes, const pipeline::RenderOptions& options,
                 int atATime, const ReportStyle& style = {});

struct RerunArguments {
  std::filesystem::path clip, folder;
  store::TextureLookup textures;
  bool png = false;
  store::EarlierFrames earlier;
  DeviceOptions deviceOptions;
};

/// Renders the clip again from its record into the folder, and reports whether the new file has the
/// very bytes of the clip; returns the exit status. The clip itself is never replaced, another
/// scene's of its name only with `earlier.overwrite`. Throws Error.
int rerun(const RerunArguments& arguments);

}  // namespace rotatebook::cli
