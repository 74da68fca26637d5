// Places of the parts of a map's designed picture. Inside the room only.
#pragma once

#include <vector>

#include "overlay/box.h"
#include "overlay/text.h"
#include "picture/map_ticks.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Places and lengths. [pixels]
struct MapLayout {
  int scale = 1;   ///< Pixels across and up for each drawn run.
  int stride = 1;  ///< Of so many runs across and up one is drawn.
  double letters = 16;
  int width = 0, height = 0;  ///< Of the picture.
  int textWidth = 0;          ///< Of title, legend and caption.
  int titleTop = 0, legendTop = 0, axisNameTop = 0, panelNameTop = 0;
  std::vector<overlay::Box> plots;  ///< One for each panel.
  int xNameTop = 0, captionTop = 0;
  std::vector<Tick> xTicks, yTicks;

  double tickLength() const { return 0.4 * letters; }
};

/// The looks of the texts, with letters of `letters` pixels.
struct MapStyles {
  explicit MapStyles(double letters);

  overlay::TextStyle title, name, bold, small, caption;
};

/// Lays out the picture of a scene's map.
MapLayout layOutMap(const scene::Scene& scene, const overlay::Typesetter& type);

/// Returns the name beside an axis.
std::string nameOf(const scene::MapAxis& axis);

}  // namespace rotatebook::picture
