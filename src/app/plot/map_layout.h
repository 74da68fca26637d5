// Places of the parts of a map's plot. Inside the room only.
#pragma once

#include <vector>

#include "plot/axes.h"
#include "scene/scene.h"

namespace rotatebook::plot {

/// Places and lengths. [pixels]
struct MapLayout {
  /// Lays out the map of `scene`, at the right of a sheet that is at least `leastWidth` wide; both
  /// sides are even.
  MapLayout(const scene::Scene& scene, const overlay::Typesetter& type, int leastWidth);

  int scale = 1;   ///< Pixels across and up for each drawn run.
  int stride = 1;  ///< Of so many runs across and up one is drawn.
  Look look;
  int width = 0, height = 0;  ///< Of the sheet.
  int textWidth = 0;          ///< Of title, legend and caption.
  int titleTop = 0, legendTop = 0, axisNameTop = 0, panelNameTop = 0;
  std::vector<Area> areas;  ///< One for each panel.
  int xNameTop = 0, captionTop = 0;
};

}  // namespace rotatebook::plot
