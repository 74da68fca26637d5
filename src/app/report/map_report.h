// Reports on maps, as text and as JSON.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "study/map_result.h"

namespace rotatebook::report {

/// A scene, and as much of its map's outcome as there is.
struct MappedScene {
  scene::Scene scene;
  std::optional<study::MapFacts> facts{};
  std::vector<study::MarkedValue> marks{};
  std::vector<study::ExpectedOfMap> expected{};
  std::vector<std::string> files{};  ///< That were written.
  bool interrupted = false;
  std::string error{};  ///< Empty if there was none.

  bool isMet() const;
};

/// Prints a line for the values, and one for each mark and each expectation.
void reportMap(const MappedScene& mapped, std::ostream& out);

/// Prints all as one JSON object. `interrupted` says that scenes were left out or undone.
void reportMapsAsJson(const std::vector<MappedScene>& maps, bool interrupted, std::ostream& out);

}  // namespace rotatebook::report
