// Reports on studies, as text and as JSON. Inside the room only.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/scene.h"
#include "store/study_files.h"
#include "study/study.h"

namespace rotatebook::cli {

/// Prints a line for each order, or else for each run, and for each expectation of `study` to
/// `out`; returns whether all expectations are met.
bool reportStudy(const study::Study& result, const scene::StudySettings& study, std::ostream& out);

/// A scene, which has a study, and as much of its outcome as there is.
struct StudiedScene {
  scene::Scene scene;
  store::StudyFiles files{};
  std::string checksum{};  ///< store::studySceneChecksum()
  std::optional<study::Study> result{};
  std::vector<std::string> written{};  ///< Of `files`.
  bool interrupted = false;
  std::string error{};  ///< Empty if there was none.
};

/// Returns the result as one JSON object.
Json studyJson(const StudiedScene& studied);

}  // namespace rotatebook::cli
