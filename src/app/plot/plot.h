// Plots as values, and how they are drawn. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot/drawing.h"
#include "scene/scale.h"

namespace rotatebook::plot {

struct Tick {
  double value;
  std::string label;  ///< Empty of a small tick.
};

/// Returns round numbers within the range, about `wanted` of them with labels; on a logarithmic
/// scale powers of ten, with small ticks between them. Round numbers of degrees are parts of a
/// right angle.
std::vector<Tick> ticksOf(double from, double to, scene::Scale scale, int wanted,
                          bool isInDegrees = false);

/// Returns a number for people: "0.01", "10⁻⁵", "−3".
std::string tickText(double value);

/// The colours of a sheet, and the looks of its texts.
struct Look {
  Look(double letters, bool isDark);

  double letters;  ///< Size of the axes' names; all distances follow from it. [pixels]
  Colour ground, grid, quiet;
  TextStyle title, name, bold, small, caption;

  Pen thin() const { return {quiet, 0.07 * letters}; }
};

/// An axis. Its numbers are round ones, unless it has words.
struct Axis {
  std::string name{};  ///< With the unit.
  double from = 0, to = 1;
  scene::Scale scale = scene::Scale::Linear;
  bool isInDegrees = false;
  std::vector<Tick> words{};

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
  Point placeOf(const Point& point) const;
  /// Returns the room for a label of x. [pixels]
  double labelRoom() const;
};

/// Draws the ticks outside the area, with their labels, those of y where they are wanted; and a
/// grid.
void drawAxes(const Area& area, const Look& look, bool hasYLabels, bool hasGrid, Drawing& drawing);

/// The look of a curve's points.
struct Marker {
  Colour colour{};
  int corners = 0;      ///< Of a regular polygon; 0 is a disc.
  double turned = 0;    ///< From one corner at the top. [share of a turn]
  bool isOpen = false;  ///< The outline alone.
  double radius = 4;    ///< [pixels]
};

/// Returns the marker of a curve, by its number modulo the number of markers. The colours are after
/// Okabe and Ito and after Tol, which colour-blind people can tell apart; all shapes differ, so
/// that the plot can be read without colours, too.
const Marker& markerOf(std::size_t number);

/// A curve; or an item of a legend, which has no points.
struct Series {
  std::string name{};  ///< In the legend, unless empty.
  Marker marker{};
  std::vector<Point> points{};
  bool hasLine = true, hasMarkers = true;
};

/// A point with a label beside it.
struct Mark {
  Point at;
  std::string label;
};

/// An area between two axes. All points are values on the axes.
struct Panel {
  std::string name{};
  Axis x{}, y{};
  bool sharesY = false;  ///< With the panel at its left, so that it has no labels of its own.
  std::optional<image::Image> picture{};
  std::vector<Point> lines{};  ///< Straight lines, point pair by point pair, below the series.
  Pen pen{};                   ///< Of these.
  std::vector<Series> series{};
  std::vector<Mark> marks{};
};

/// The colours of a picture's values.
struct ColourBar {
  Axis axis{};
  image::Image colours{};  ///< One row.
};

/// Panels side by side, below a title and one legend.
struct Plot {
  std::string title, caption{};
  std::string legendTitle{};
  std::optional<ColourBar> bar{};
  std::vector<Series> legend{};  ///< Items beside those of the panels' series.
  std::vector<Panel> panels{};
  double letters = 15;  ///< [pixels]
  bool isDark = false;
  double areaWidth = 0, areaHeight = 400;  ///< Of each panel; 0 for a share of the sheet. [pixels]
  /// Of the sheet, whose sides are even; what is wider has its contents at the right. [pixels]
  double leastWidth = 1200;
};

/// Returns the lines, point pair by point pair, along which the values reach `level`; coordinates
/// are numbers of runs from the left bottom, those of a run's middle being whole. No line crosses
/// runs without a number. Uses marching squares.
std::vector<Point> contourOf(const std::vector<double>& values, int width, int height,
                             double level);

/// Draws the plot. Throws InputError if the font lacks a letter.
Drawing drawPlot(const Plot& plot, overlay::Typesetter type);

/// Returns the width of that drawing. [pixels]
double widthOf(const Plot& plot, const overlay::Typesetter& type);

}  // namespace rotatebook::plot
