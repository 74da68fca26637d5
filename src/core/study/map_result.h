// The results of a map, and what is expected of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/map_settings.h"
#include "scene/scene.h"
#include "study/map_runs.h"
#include "study/run_value.h"

namespace rotatebook::study {

/// A mark of a map, and the value of its run.
struct MarkedValue {
  scene::MapMark mark;
  std::vector<double> values{};  ///< One for each panel.
};

/// The values of a map, those of MapRuns.
struct MapResult {
  std::vector<std::string> labels;          ///< Of the panels; of a single motion, "".
  std::vector<std::vector<double>> values;  ///< Of each panel, row by row from the bottom.
  std::vector<MarkedValue> marks{};
};

/// Numbers of a whole map, or of some of its panels. NaN without any value.
struct MapFacts {
  std::int64_t runs = 0, never = 0, diverged = 0, refused = 0;
  double smallest = kRefused, largest = kRefused, mean = kRefused;

  std::int64_t withValue() const { return runs - never - diverged - refused; }
};

/// A number that is expected of a map.
struct ExpectedOfMap {
  scene::MapExpectation expectation;
  double measured = kRefused;

  bool isMet() const { return expectation.bounds.hold(measured); }
  /// Returns "share over 90, of the panel rk4".
  std::string subject() const;
};

/// Returns a result without values, to put those of tiles into, and with those of the marks.
MapResult emptyResult(const scene::Scene& scene, const MapRuns& runs);
/// Puts the values of a tile into their places.
void putTile(const MapTile& tile, const std::vector<double>& values, const scene::MapSettings& map,
             MapResult& result);

/// Returns the numbers of all panels together.
MapFacts factsOf(const MapResult& result);

/// Returns all that is expected of the map, in the order of its settings.
std::vector<ExpectedOfMap> expectedOf(const MapResult& result, const scene::MapSettings& map,
                                      const MapRuns& runs);

}  // namespace rotatebook::study
