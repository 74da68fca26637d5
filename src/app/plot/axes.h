// Axes of plots and maps: their ticks, numbers and names, and the looks of both. Inside the room
// only.
#pragma once

#include <string>
#include <vector>

#include "plot/drawing.h"
#include "plot/ticks.h"

namespace rotatebook::plot {

/// The colours of a sheet, and the looks of its texts.
struct Look {
  Look(double letters, bool isDark);

  double letters;  ///< Size of the axes' names; all distances follow from it. [pixels]
  Colour ground, grid, quiet;
  TextStyle title, name, bold, small, caption;

  Pen thin() const { return {quiet, 0.07 * letters}; }
};

/// An axis. Its numbers are those of `ticks`, or, if there are none, round ones.
struct Axis {
  std::string name;  ///< With the unit.
  double from = 0, to = 1;
  scene::Scale scale = scene::Scale::Linear;
  bool isInDegrees = false;
  std::vector<Tick> words{};  ///< In place of numbers.

  /// Returns the ticks, about `wanted` of them with labels.
  std::vector<Tick> ticks(double wanted) const;
  double shareOf(double value) const { return scene::shareOf(value, from, to, scale); }
};

/// An area on a sheet, and its axes.
struct Area {
  Box box;
  Axis x, y;
  std::vector<Tick> xTicks{}, yTicks{};

  /// Chooses as many ticks as there is room for.
  void chooseTicks(const Look& look);
  /// Returns the place of a point on the sheet.
  Point placeOf(double xValue, double yValue) const;
};

/// Returns the width of the widest label. [pixels]
int widestLabel(const std::vector<Tick>& ticks, const Look& look, const overlay::Typesetter& type);

/// The parts of axes that are drawn.
struct AxesShown {
  bool hasYLabels = true;
  bool hasGrid = false;
};

/// Draws the ticks outside the area, with their labels.
void drawAxes(const Area& area, const Look& look, const AxesShown& shown, Drawing& drawing);

}  // namespace rotatebook::plot
