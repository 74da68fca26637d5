// Reports on studies, as text and as JSON.
#pragma once

#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "scene/study_settings.h"
#include "study/study.h"
#include "study/sweep.h"

namespace rotatebook::report {

// Each prints a line for each integrator, tilt or run and for each expectation of `study` to `out`;
// returns whether all expectations are met.

bool reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                 std::ostream& out);
bool reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                 std::ostream& out);
bool reportStudy(const study::SweepStudy& result, const scene::StudySettings& study,
                 std::ostream& out);

/// A scene, and as much of its study's outcome as there is.
struct StudiedScene {
  scene::Scene scene;
  scene::StudySettings study;
  std::string checksum{};  ///< store::studySceneChecksum()
  std::variant<std::monostate, study::PrecisionStudy, study::TiltStudy, study::SweepStudy> result{};
  std::vector<std::string> files{};  ///< Tables, plots and JSON that were written.
  bool interrupted = false;
  std::string error{};  ///< Empty if there was none.
};

/// Returns the result as one JSON object.
std::string studyJson(const StudiedScene& studied);
/// Prints all as one JSON object. `interrupted` says that scenes were left out or undone.
void reportStudiesAsJson(const std::vector<StudiedScene>& studies, bool interrupted,
                         std::ostream& out);

}  // namespace rotatebook::report
