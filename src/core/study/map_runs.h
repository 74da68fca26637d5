// Maps: what is run for each pixel of a picture.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "scene/scene.h"
#include "study/execution.h"

namespace rotatebook::study {

/// A rectangle of a panel's pixels. Rows are counted from the bottom.
struct MapTile {
  std::size_t panel = 0;
  int left = 0, bottom = 0;
  int width = 0, height = 0;

  friend bool operator==(const MapTile&, const MapTile&) = default;
};

/// The runs of a scene's map. Each value is a function of the scene and the point alone. Use it on
/// several threads.
class MapRuns {
 public:
  /// Takes a scene that has a map.
  explicit MapRuns(const scene::Scene& scene);
  ~MapRuns();

  std::size_t panels() const;
  /// Returns tiles that hold each pixel of all panels once. They depend on the scene alone, so that
  /// the values don't depend on who computes them. A tile spans an axis along which there is but
  /// one motion, such as that of time.
  std::vector<MapTile> tiles() const;
  /// Returns the values of a tile, row by row from the bottom. If `stop` isn't null and is set, the
  /// values must be discarded.
  std::vector<double> valuesOf(const MapTile& tile, Stop stop = nullptr) const;
  /// Returns the value at a point of a panel.
  double valueAt(std::size_t panel, double x, double y) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::study
