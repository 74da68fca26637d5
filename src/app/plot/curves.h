// Plots of curves, as values and drawn.
#pragma once

#include <string>
#include <vector>

#include "plot/axes.h"

namespace rotatebook::plot {

/// The look of a curve's points.
struct Marker {
  Colour colour{};
  int corners = 0;      ///< Of a regular polygon; 0 is a disc.
  double turned = 0;    ///< From one corner at the top. [share of a turn]
  bool isOpen = false;  ///< The outline alone.
  double radius = 4;    ///< [pixels]
};

/// Returns the marker of a curve, by its number modulo the number of markers. The colours are after
/// Okabe and Ito and after Tol, which colour-blind people can tell apart; each model's integrators
/// have different shapes, so that the plot can be read without colours, too.
const Marker& markerOf(std::size_t number);

/// A curve through points, whose coordinates are values on the axes.
struct Series {
  std::string name{};  ///< In the legend, unless empty.
  Marker marker{};
  std::vector<Point> points{};
  bool hasLine = true, hasMarkers = true;
};

/// Curves between two axes.
struct CurvesPanel {
  Axis x, y;
  bool sharesY = false;  ///< With the panel at its left, so that it has no labels of its own.
  std::vector<Series> series{};
  /// Grey straight lines, point pair by point pair.
  std::vector<Point> guides{};
};

/// Panels side by side, with one legend at their right.
struct CurvesPlot {
  std::string title;
  std::string note{};         ///< Below the title.
  std::string legendTitle{};  ///< Above the names.
  std::vector<CurvesPanel> panels{};
};

/// Draws the plot on white ground. Throws InputError if the font lacks a letter.
Drawing drawCurves(const CurvesPlot& plot, overlay::Typesetter type);

}  // namespace rotatebook::plot
