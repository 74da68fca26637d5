#include "picture/plot_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "base/text.h"
#include "picture/gnuplot.h"

namespace rotatebook::picture {
namespace {

constexpr std::array<PlotStyle, 16> kStyles{{
    {"#000000", 7},
    {"#d55e00", 9},
    {"#7f7f7f", 6},
    {"#e69f00", 8},
    {"#0072b2", 5},
    {"#009e73", 11},
    {"#56b4e9", 4},
    {"#cc79a7", 13},
    {"#882255", 12},
    {"#332288", 15},
    {"#0072b2", 5},
    {"#009e73", 11},
    {"#aa4499", 2},
    {"#117733", 14},
    {"#999933", 10},
    {"#cc6677", 3},
}};

std::string rangeText(const PlotRange& range) {
  return "[" + shortestText(range.min) + ":" + shortestText(range.max) + "]";
}

/// Returns the first `count` letters, with an ellipsis if there are more.
std::string shortened(const std::string& text, std::size_t count) {
  const std::string shown(firstCharacters(text, count));
  return shown.size() < text.size() ? shown + "…" : text;
}

}  // namespace

const PlotStyle& plotStyle(std::size_t number) {
  return kStyles[number % kStyles.size()];
}

PlotRange logarithmicRange(const std::vector<double>& values) {
  constexpr double kMargin = 2;
  PlotRange range{std::numeric_limits<double>::infinity(), 0};
  for (const double value : values) {
    if (!(value > 0)) continue;
    range = {std::min(range.min, value), std::max(range.max, value)};
  }
  if (range.max == 0) return {1e-16, 1};
  const double widening = std::sqrt(std::max(1.0, 10 * range.min / range.max));
  return {range.min / (kMargin * widening), range.max * kMargin * widening};
}

std::string panelText(const PlotPanel& panel) {
  return "unset arrow\nunset label\nset lmargin at screen " + shortestText(panel.edges.left) +
         "\nset rmargin at screen " + shortestText(panel.edges.right) + "\nset xrange " +
         rangeText(panel.x) + "\nset yrange " + rangeText(panel.y) + "\n";
}

std::string sheetText() {
  return "set encoding utf8\n"
         "set tmargin at screen 0.895\nset bmargin at screen 0.13\n"
         "set border 31 linecolor rgb '#606060' linewidth 1\n"
         "set tics textcolor rgb '#303030'\n"
         "set grid linetype 1 linecolor rgb '#e4e4e4' linewidth 0.8\n"
         "set key off\nset multiplot\n";
}

std::string titleText(const std::string& title) {
  constexpr std::size_t kLarge = 90, kSmall = 150;  // letters that fill 0.8 of the page
  const bool fits = shortened(title, kLarge) == title;
  return "set label 1 " + gnuplotString(shortened(title, kSmall)) +
         " at screen 0.5,0.95 center noenhanced font '," + (fits ? "17" : "10.5") + "'\n";
}

std::string seriesStyle(const char* colour, int point) {
  return std::string(" with linespoints linecolor rgb '") + colour + "' linewidth 1.6 pointtype " +
         std::to_string(point) + " pointsize point_size";
}

}  // namespace rotatebook::picture
