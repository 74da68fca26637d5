// The sheet of a plot: its look, title, panels and series, as gnuplot's commands. Inside the room
// only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rotatebook::picture {

/// The look of a curve.
struct PlotStyle {
  const char* colour;
  int point;  ///< gnuplot's pointtype
};

/// Returns the style of a curve, by its number modulo the number of styles. The colours are after
/// Okabe and Ito and after Tol, which colour-blind people can tell apart; each model's integrators
/// have different point shapes, so that the plot can be read without colours, too.
const PlotStyle& plotStyle(std::size_t number);

/// The range of an axis, from `min` to `max`.
struct PlotRange {
  double min = 0;
  double max = 0;
};

/// Returns a range for the positive `values` on a logarithmic axis: at least a decade, so that it
/// contains a power of ten.
PlotRange logarithmicRange(const std::vector<double>& values);

/// The left and right edge of a panel, as fractions of the page.
struct PlotEdges {
  double left, right;
};

/// A panel, and the ranges of its axes.
struct PlotPanel {
  PlotEdges edges;
  PlotRange x, y;
};

/// Sets up the sheet.
std::string sheetText();
/// Begins a panel.
std::string panelText(const PlotPanel& panel);
/// Sets the title large if it fits on the page, else small, shortened to what fits.
std::string titleText(const std::string& title);
/// Returns the style of a series of points joined by lines.
std::string seriesStyle(const char* colour, int point);

}  // namespace rotatebook::picture
