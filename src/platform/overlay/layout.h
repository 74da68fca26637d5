// Where the insets are. Inside the room only.
#pragma once

#include <vector>

#include "overlay/box.h"
#include "overlay/palette.h"

namespace rotatebook::overlay {

/// What needs a place.
struct Wanted {
  bool square = false;  ///< An inset as wide as high.
  int charts = 0;       ///< Strip charts, one above the other or side by side.
  bool legend = false;  ///< Of what is on the book.
  int bottomRows = 0;   ///< Rows that words take at the bottom. [pixels]
};

/// Boxes that don't meet, within the picture's margins; empty where nothing is wanted. [pixels]
struct Layout {
  Box square{};
  std::vector<Box> charts{};
  Box legend{};
  int bottomRows = 0;  ///< Those of Wanted, and of what is above them.
};

/// On a wide picture a column on the right, beside the book; on a narrow one the charts below the
/// book, as many as leave it most of the picture, and the square in the corner above it.
Layout layOut(const Scale& scale, const Wanted& wanted);

}  // namespace rotatebook::overlay
