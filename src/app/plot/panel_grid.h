// Arranges the panels of a picture.
#pragma once

#include <vector>

namespace rotatebook::plot {

/// Panels of one size in rows and columns, with thin gaps between them.
struct PanelGrid {
  /// The top left of a panel. [pixels]
  struct Position {
    int x = 0;
    int y = 0;
  };

  int width = 0;                    ///< Of each panel, > 0. [pixels]
  int height = 0;                   ///< Of each panel, > 0. [pixels]
  std::vector<Position> positions;  ///< In reading order; an incomplete last row is centred.
};

/// Arranges `count` >= 1 panels on `width` x `height` pixels such that a panel's shorter side is as
/// long as possible, with the fewest empty cells, then the fewest rows among equals. A single panel
/// fills the picture.
PanelGrid panelGrid(int count, int width, int height);

}  // namespace rotatebook::plot
