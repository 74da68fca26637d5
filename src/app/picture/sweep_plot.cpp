// Plots the results of a study over any key.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "picture/gnuplot.h"
#include "picture/plot_sheet.h"
#include "picture/study_plot.h"

namespace rotatebook::picture {
namespace {

// An axis whose values span more than this is logarithmic.
constexpr double kWideSpan = 20;

/// A run on a panel.
struct Point {
  double x, y;
  bool isOpen;  ///< Not measured but known to lie above: a motion that hasn't diverged.
};

struct Series {
  std::string label;
  std::vector<Point> points;
};

bool allNumbers(const scene::SweepKey& key) {
  return std::ranges::all_of(key.values,
                             [](const auto& value) { return value.number.has_value(); });
}

/// Returns the place of a value on the horizontal axis: the number, or its rank from 1.
double placeOf(const std::string& label, const scene::SweepKey& key) {
  const auto found = std::ranges::find(key.values, label, &scene::SweepValue::label);
  return allNumbers(key) ? *found->number : static_cast<double>(found - key.values.begin() + 1);
}

std::vector<Series> seriesOf(const study::SweepStudy& study, const scene::Sweep& sweep,
                             std::size_t measure) {
  std::vector<Series> all;
  for (const study::SweepRow& row : study.rows) {
    if (all.empty() || all.back().label != row.curve) all.push_back({row.curve, {}});
    const double value = row.measured[measure];
    if (std::isnan(value)) continue;
    const bool isOpen = std::isinf(value);
    all.back().points.push_back(
        {placeOf(row.value, sweep.over), isOpen ? row.length : value, isOpen});
  }
  return all;
}

struct Axis {
  PlotRange range;
  bool isLogarithmic = false;
};

Axis axisFor(const std::vector<double>& values, bool fromZero) {
  const auto [least, most] = std::ranges::minmax(values);
  if (least > 0 && most > kWideSpan * least) return {logarithmicRange(values), true};
  const double low = fromZero && least >= 0 ? 0 : least, span = most > low ? most - low : 1;
  return {{low == 0 && fromZero ? 0 : low - 0.06 * span, most + 0.1 * span}, false};
}

/// Returns the values on an axis of all points, or {0, 1} if there are none.
template <typename Coordinate>
std::vector<double> valuesOf(const std::vector<Series>& all, Coordinate coordinate) {
  std::vector<double> values;
  for (const Series& series : all) {
    for (const Point& point : series.points) values.push_back(point.*coordinate);
  }
  return values.empty() ? std::vector<double>{0, 1} : values;
}

std::string scaleText(const char* axis, bool isLogarithmic) {
  return std::string(isLogarithmic ? "set" : "unset") + " logscale " + axis + "\nset format " +
         axis + (isLogarithmic ? " '%h'\n" : " '%g'\n");
}

std::string xTicks(const scene::SweepKey& key) {
  if (allNumbers(key)) return "set xtics auto\n";
  std::string ticks;
  for (std::size_t i = 0; i < key.values.size(); ++i) {
    ticks += (i > 0 ? "," : "") + gnuplotString(key.values[i].label) + " " + std::to_string(i + 1);
  }
  return "set xtics (" + ticks + ") noenhanced\n";
}

std::string blockOf(const Series& series, bool isOpen, const std::string& name) {
  std::string block = name + " << END\n";
  for (const Point& point : series.points) {
    if (point.isOpen == isOpen) block += shortestText(point.x) + " " + shortestText(point.y) + "\n";
  }
  return block + "END\n";
}

bool hasOpen(const Series& series) {
  return std::ranges::any_of(series.points, &Point::isOpen);
}

/// Words have no order, so that no line joins their points.
std::string pointStyle(const char* colour, int point) {
  return std::string(" with points linecolor rgb '") + colour + "' pointtype " +
         std::to_string(point) + " pointsize 1.6*point_size";
}

/// Returns the data and the commands of one panel, with those of the sheet's title, if any; the
/// last one has the legend.
std::string panelOf(const std::vector<Series>& all, const scene::Sweep& sweep, std::size_t measure,
                    const PlotEdges& edges, const std::string& titled) {
  const Axis x = axisFor(valuesOf(all, &Point::x), false),
             y = axisFor(valuesOf(all, &Point::y), true);
  const bool isNumeric = allNumbers(sweep.over);
  std::string blocks, plots;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = "$m" + std::to_string(measure) + "_" + std::to_string(i);
    const auto& [colour, point] = plotStyle(i);
    blocks += blockOf(all[i], false, name) + blockOf(all[i], true, name + "_open");
    plots += std::string(plots.empty() ? "plot " : ", ") + name + " using 1:2" +
             (isNumeric ? seriesStyle(colour, point) : pointStyle(colour, point)) + " title " +
             gnuplotString(all[i].label);
    if (!hasOpen(all[i])) continue;
    plots += ", " + name + "_open using 1:2 with points pointtype 8 pointsize 1.3*point_size " +
             "linecolor rgb '" + colour + "' notitle";
  }
  const std::string key = measure + 1 == sweep.measures.size() && sweep.curves
                              ? "set key at screen 0.815,0.87 left top Left reverse noenhanced "
                                "spacing 1.5 samplen 2.5 font ',12'\nset label 2 " +
                                    gnuplotString(sweep.curves->key) +
                                    " at screen 0.82,0.885 left noenhanced font ',11'\n"
                              : "set key off\n";
  const std::string open =
      std::ranges::any_of(all, hasOpen)
          ? "set label 'open triangles: not within the run' at graph 0.03,0.96 left textcolor rgb "
            "'#808080' font ',11'\n"
          : "";
  return blocks + scaleText("x", x.isLogarithmic) + scaleText("y", y.isLogarithmic) +
         panelText({edges, x.range, y.range}) + titled + xTicks(sweep.over) + key + open +
         "set xlabel " + gnuplotString(sweep.over.key) + " noenhanced\nset ylabel " +
         gnuplotString(std::string(rowOf(sweep.measures[measure]).studied)) + "\n" + plots + "\n";
}

}  // namespace

std::string sweepPlot(const std::string& title, const study::SweepStudy& study,
                      const scene::Sweep& sweep) {
  constexpr double kLeft = 0.095, kGap = 0.105;  // room for six letters and the name of the axis
  const double right = sweep.curves ? 0.8 : 0.97;
  const auto panels = static_cast<double>(sweep.measures.size());
  const double width = (right - kLeft - (panels - 1) * kGap) / panels;
  std::string text = sheetText();
  for (std::size_t i = 0; i < sweep.measures.size(); ++i) {
    const double left = kLeft + static_cast<double>(i) * (width + kGap);
    text += panelOf(seriesOf(study, sweep, i), sweep, i, {left, left + width},
                    i == 0 ? titleText(title) : "");
  }
  return text + "unset multiplot\n";
}

}  // namespace rotatebook::picture
