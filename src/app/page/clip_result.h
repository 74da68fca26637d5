// The result of a clip, as its render left it in NAME.json. Inside the room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "page/expectation_table.h"
#include "scene/scene.h"
#include "timeline/clip_events.h"

namespace rotatebook::page {

/// One of the motions that a clip shows.
struct MotionResult {
  std::optional<double> divergedAt{};  ///< [s]
  std::vector<Check> checks{};
};

/// The result of a clip: timeline::clipJson().
struct ClipResult {
  std::int64_t frames = 0;
  std::vector<MotionResult> motions{};  ///< In the order of Scene::motions.
  std::vector<timeline::ClipEvent> events{};
  /// "plots" with "rate", "frames" and, unless it is empty, "checksum"; safe in a <script>.
  std::string plots{};
};

/// Reads the result of the clip of `scene` from `file`; `checksum` is that of its motion by the
/// clip's record. Throws InputError, with the remedy, unless the file is that.
ClipResult readClipResult(const std::filesystem::path& file, const scene::Scene& scene,
                          const std::string& checksum, const Language& say);

}  // namespace rotatebook::page
