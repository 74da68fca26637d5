// Where the panels of a picture are. Inside the room only.
#pragma once

#include <vector>

namespace rotatebook::picture {

/// Panels of one size in rows and columns, with thin gaps between them.
struct PanelGrid {
  /// Top left of a panel. [pixels]
  struct Place {
    int x = 0;
    int y = 0;
  };

  int width = 0;              ///< Of each panel, > 0. [pixels]
  int height = 0;             ///< Of each panel, > 0. [pixels]
  std::vector<Place> places;  ///< In the order of reading; a last row that isn't full is centred.
};

/// The grid of `count` >= 1 panels that fills `width` x `height` pixels best: with the longest
/// shorter side of a panel, and of those with the fewest rows. A single panel fills all.
PanelGrid panelGrid(int count, int width, int height);

}  // namespace rotatebook::picture
