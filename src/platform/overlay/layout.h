// Arranges the insets on a picture. Inside the room only.
#pragma once

#include <vector>

#include "overlay/box.h"
#include "overlay/palette.h"

namespace rotatebook::overlay {

/// The insets that need room.
struct Wanted {
  bool square = false;     ///< An inset as wide as high.
  int charts = 0;          ///< Strip charts, one above the other or side by side.
  double legend = 0;       ///< Height of a legend of what is drawn on the body. [small letters]
  double leastLegend = 0;  ///< Its height where it would be in the body's way. [small letters]
  int bottomRows = 0;      ///< Rows that text takes at the bottom. [pixels]
};

/// Boxes that don't meet, within the picture's margins; empty if not wanted. [pixels]
struct Layout {
  Box square{};
  std::vector<Box> charts{};
  Box legend{};
  int bottomRows = 0;  ///< Rows that Wanted::bottomRows and the charts above them take.
};

/// Arranges the insets: on a wide picture in a column on the right, beside the book; on a narrow
/// one the charts below the book, as many as leave it most of the picture, and the square in the
/// corner above it.
Layout layOut(const Scale& scale, const Wanted& wanted);

}  // namespace rotatebook::overlay
