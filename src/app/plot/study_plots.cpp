#include "plot/study_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "base/text.h"
#include "plot/plot.h"
#include "scene/axis.h"
#include "scene/key_rows.h"
#include "scene/names.h"

namespace rotatebook::plot {
namespace {

using scene::Measure;
using scene::Scale;

constexpr double kWideSpan = 20;   // An axis whose values span more than this is logarithmic.
constexpr double kOpenRadius = 6;  // [pixels]
constexpr Colour kGrey{0.66, 0.66, 0.66};

/// Returns an axis for the positive `values`: at least a decade, so that it holds a power of ten.
Axis logarithmicAxis(const std::string& name, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !(value > 0); });
  if (values.empty()) return {name, 1e-16, 1, Scale::Logarithmic};
  const auto [least, most] = std::ranges::minmax(values);
  const double widening = 2 * std::sqrt(std::max(1.0, 10 * least / most));
  return {name, least / widening, most * widening, Scale::Logarithmic};
}

Axis axisFor(const std::string& name, const std::vector<double>& values, bool fromZero) {
  if (values.empty()) return {name, 0, 1};
  const auto [least, most] = std::ranges::minmax(values);
  if (least > 0 && most > kWideSpan * least) return logarithmicAxis(name, values);
  const bool isFromZero = fromZero && least >= 0;
  const double low = isFromZero ? 0 : least, span = most > low ? most - low : 1;
  return {name, isFromZero ? 0 : low - 0.06 * span, most + 0.1 * span};
}

/// Returns the values of all points along one axis, 0 for x and 1 for y.
std::vector<double> valuesAlong(int axis, const std::vector<Series>& all) {
  std::vector<double> values;
  for (const Series& series : all) {
    for (const Point& point : series.points) values.push_back(point[axis]);
  }
  return values;
}

/// Adds a grey line y ~ x^exponent from the panel's upper right corner if it rises, else from the
/// upper left one.
void addSlope(int exponent, Panel& panel) {
  const double start = exponent > 0 ? panel.x.to : panel.x.from;
  const double end = exponent > 0 ? panel.x.from : panel.x.to;
  const double bottom = start * std::pow(panel.y.from / panel.y.to, 1.0 / exponent);
  const double x = (bottom < end) == (exponent > 0) ? end : bottom;
  panel.lines.emplace_back(start, panel.y.to);
  panel.lines.emplace_back(x, panel.y.to * std::pow(x / start, exponent));
  panel.pen = {kGrey, 1};
}

/// Returns the legend of such lines.
std::vector<Series> legendOf(const std::set<int>& slopes) {
  std::vector<std::string> texts;
  for (const int slope : slopes) texts.push_back(std::to_string(slope));
  if (texts.empty()) return {};
  return {{(texts.size() == 1 ? "slope " : "slopes ") + listed(texts), {kGrey}, {}, true, false}};
}

Panel panelOf(Axis x, Axis y, std::vector<Series> series, bool sharesY = false) {
  Panel panel{"", std::move(x), std::move(y), sharesY};
  panel.series = std::move(series);
  return panel;
}

Panel logarithmicPanel(const char* x, const char* y, const std::vector<Series>& series,
                       bool sharesY = false) {
  return panelOf(logarithmicAxis(x, valuesAlong(0, series)),
                 logarithmicAxis(y, valuesAlong(1, series)), series, sharesY);
}

/// Returns the curve's name and its fitted order.
std::string nameOf(const study::CurveOrder& order) {
  const double fitted = order.fit.order;
  return (order.curve.empty() ? "" : order.curve + "  ") +
         (std::isnan(fitted) ? "–" : fmt::format("{:.2f}", fitted));
}

/// Returns the errors over `across`, of the runs that show one, curve by curve.
template <typename Across>
std::vector<Series> errorsOver(const study::Study& study, std::size_t place, const Across& across) {
  std::vector<Series> all;
  for (const study::CurveOrder& order : study.orders) {
    Series series{nameOf(order), markerOf(all.size())};
    for (const study::StudyRow& row : study.rows) {
      const double error = row.measured[place];
      if (row.curve == order.curve && error > 0) series.points.emplace_back(across(row), error);
    }
    all.push_back(std::move(series));
  }
  return all;
}

std::set<int> slopesOf(const study::Study& study) {
  std::set<int> slopes;
  for (const auto& [curve, fit] : study.orders) {
    if (!std::isnan(fit.order) && fit.order > 0.5) slopes.insert(static_cast<int>(fit.order + 0.5));
  }
  return slopes;
}

/// Adds the panels of an order: errors over the step, and over what it costs.
void addOrder(const study::Study& result, std::size_t place, Plot& plot) {
  const std::string error(rowOf(Measure::Order).studied);
  plot.panels.push_back(
      logarithmicPanel("step  [s]", error.c_str(),
                       errorsOver(result, place, [](const auto& row) { return row.step; })));
  plot.panels.push_back(logarithmicPanel(
      "computing time for a second of motion  [ns]", "",
      errorsOver(result, place, [](const auto& row) { return row.nsPerStep / row.step; }), true));
  const std::set<int> slopes = slopesOf(result);
  plot.legendTitle = "fitted order";
  plot.legend = legendOf(slopes);
  for (const int slope : slopes) {
    addSlope(slope, plot.panels[plot.panels.size() - 2]);
    addSlope(-slope, plot.panels.back());
  }
}

/// Returns the place of a value on the horizontal axis: the number, or its rank from 1.
double placeOf(const std::string& label, const scene::Axis& key) {
  const auto found = std::ranges::find(key.values, label, &scene::AxisValue::label);
  return key.hasNumbers() ? *found->number : static_cast<double>(found - key.values.begin() + 1);
}

/// Returns a curve for each value of the second key, each followed by the points of runs that are
/// not measured but known to lie above: of motions that haven't diverged.
std::vector<Series> seriesOf(const study::Study& result, const scene::StudySettings& study,
                             std::size_t measure) {
  std::vector<Series> all;
  const std::string* curve = nullptr;
  for (const study::StudyRow& row : result.rows) {
    if (curve == nullptr || *curve != row.curve) {
      curve = &row.curve;
      Marker marker = markerOf(all.size() / 2);
      // Words have no order, so that no line joins their points.
      if (!study.x.hasNumbers()) marker.radius = kOpenRadius;
      all.push_back({row.curve, marker, {}, study.x.hasNumbers()});
      all.push_back({"", {marker.colour, 3, 0, true, kOpenRadius}, {}, false});
    }
    const double value = row.measured[measure];
    if (std::isnan(value)) continue;
    const bool isOpen = std::isinf(value);
    all[all.size() - (isOpen ? 1 : 2)].points.emplace_back(placeOf(row.value, study.x),
                                                           isOpen ? row.length : value);
  }
  return all;
}

/// Returns the axis of the key that is varied; words are at their ranks.
Axis studyAxis(const scene::Axis& key) {
  std::vector<double> places;
  Axis axis{scene::nameOf(key), 0.5, 0.5 + static_cast<double>(key.values.size())};
  for (const scene::AxisValue& value : key.values) {
    places.push_back(placeOf(value.label, key));
    axis.words.push_back({places.back(), value.label});
  }
  return key.hasNumbers() ? axisFor(axis.name, places, false) : axis;
}

}  // namespace

Plot plotOf(const study::Study& result, const scene::StudySettings& study) {
  Plot plot{.title = {}, .legendTitle = study.curves ? scene::nameOf(*study.curves) : ""};
  const bool hasOpen = std::ranges::any_of(result.rows, [](const study::StudyRow& row) {
    return std::ranges::any_of(row.measured, [](double value) { return std::isinf(value); });
  });
  if (hasOpen) {
    plot.legend = {{"not within the run", {kGrey, 3, 0, true, kOpenRadius}, {}, false}};
  }
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    if (study.measures[i] == Measure::Order) {
      addOrder(result, i, plot);
      continue;
    }
    const std::vector<Series> series = seriesOf(result, study, i);
    const std::string name(rowOf(study.measures[i]).studied);
    plot.panels.push_back(
        panelOf(studyAxis(study.x), axisFor(name, valuesAlong(1, series), true), series));
  }
  return plot;
}

std::vector<PlotFile> studyPlot(const study::Study& result, const scene::Scene& scene,
                                const std::vector<std::filesystem::path>& files) {
  constexpr double kPixels = 1.5;  // of a PNG, for one of the sheet
  Plot plot = plotOf(result, *scene.study);
  plot.title = scene.title;
  return filesOf(drawPlot(plot, lettersOf(scene)), files, kPixels);
}

void requireStudyLetters(const scene::Scene& scene) {
  std::vector<std::string> texts{scene.title};
  for (const scene::AxisValue& value : scene.study->x.values) texts.push_back(value.label);
  for (const scene::StudyRun& run : scene.runs) texts.push_back(run.curve);
  Drawing drawing(1, 1, {}, lettersOf(scene));
  for (const std::string& text : texts) drawing.write(text, {}, Point(0, 0));
}

}  // namespace rotatebook::plot
