#include "picture/study_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "base/number_text.h"
#include "base/text.h"
#include "picture/gnuplot.h"
#include "picture/plot_sheet.h"
#include "scene/names.h"

namespace rotatebook::picture {
namespace {

const PlotStyle& styleOf(physics::Integrator integrator) {
  return plotStyle(static_cast<std::size_t>(integrator));
}

std::string number(double value) {
  return shortestText(value);
}

/// Draws a grey line y ~ x^exponent from the panel's upper right corner if it rises, else from the
/// upper left one.
std::string slopeLine(const PlotPanel& panel, int exponent) {
  const double start = exponent > 0 ? panel.x.max : panel.x.min;
  const double end = exponent > 0 ? panel.x.min : panel.x.max;
  const double bottom = start * std::pow(panel.y.min / panel.y.max, 1.0 / exponent);
  const bool leavesBySide = (bottom < end) == (exponent > 0);
  const double x = leavesBySide ? end : bottom;
  const double y = panel.y.max * std::pow(x / start, exponent);
  return "set arrow from " + number(start) + "," + number(panel.y.max) + " to " + number(x) + "," +
         number(y) + " nohead back linewidth 0.8 linecolor rgb '#a8a8a8'\n";
}

std::string slopeLines(const PlotPanel& panel, const std::set<int>& slopes, int sign) {
  std::string lines;
  for (const int slope : slopes) lines += slopeLine(panel, sign * slope);
  return lines;
}

// --- Work and precision ---

std::string blockName(std::size_t index) {
  return "$runs" + std::to_string(index);
}

std::string dataBlocks(const study::PrecisionStudy& study) {
  std::string blocks;
  for (std::size_t i = 0; i < study.orders.size(); ++i) {
    blocks += blockName(i) + " << END\n";
    for (const study::PrecisionRow& row : study.rows) {
      const bool shown = row.integrator == study.orders[i].integrator &&
                         row.end.kind == study::RunEnd::Kind::Whole && row.errorDeg > 0;
      if (!shown) continue;
      blocks +=
          number(row.h) + " " + number(row.errorDeg) + " " + number(row.nsPerStep / row.h) + "\n";
    }
    blocks += "END\n";
  }
  return blocks;
}

/// Returns the integrator's name and its fitted order.
std::string legendOf(const study::IntegratorOrder& order) {
  std::array<char, 32> fitted;
  std::snprintf(fitted.data(), fitted.size(), "%.2f", order.fit.order);
  return std::string(scene::nameOf(scene::kIntegrators, order.integrator)) + "  " +
         (std::isnan(order.fit.order) ? "–" : fitted.data());
}

std::string precisionSeries(const study::PrecisionStudy& study, int xColumn) {
  std::string series;
  for (std::size_t i = 0; i < study.orders.size(); ++i) {
    const auto& [colour, point] = styleOf(study.orders[i].integrator);
    series += std::string(series.empty() ? "plot " : ", ") + blockName(i) + " using " +
              std::to_string(xColumn) + ":2" + seriesStyle(colour, point) + " title " +
              gnuplotString(legendOf(study.orders[i]));
  }
  return series + "\n";
}

std::set<int> slopesOf(const study::PrecisionStudy& study) {
  std::set<int> slopes;
  for (const auto& [integrator, fit] : study.orders) {
    if (!std::isnan(fit.order) && fit.order > 0.5) slopes.insert(static_cast<int>(fit.order + 0.5));
  }
  return slopes;
}

/// Explains the grey lines, below the legend.
std::string slopesLabel(const std::set<int>& slopes) {
  if (slopes.empty()) return "";
  return "set label 3 'grey: slopes " +
         joinedOf(slopes, [](int slope) { return std::to_string(slope); }) +
         "' at screen 0.795,0.14 left textcolor rgb '#808080' font ',11'\n";
}

/// Returns steps, errors and computing times of the complete runs.
std::array<std::vector<double>, 3> shownValues(const study::PrecisionStudy& study) {
  std::array<std::vector<double>, 3> values;
  for (const study::PrecisionRow& row : study.rows) {
    if (row.end.kind != study::RunEnd::Kind::Whole) continue;
    values[0].push_back(row.h);
    values[1].push_back(row.errorDeg);
    values[2].push_back(row.nsPerStep / row.h);
  }
  return values;
}

// --- Tilts ---

std::string tiltData(const study::TiltStudy& study) {
  std::string block = "$tilts << END\n";
  for (const study::TiltRow& row : study.rows) {
    if (std::isnan(row.interval)) continue;
    block += number(row.tilt) + " " + number(row.interval) + " " + number(row.law) + " " +
             number(std::fabs(row.ratio() - 1)) + "\n";
  }
  return block + "END\n";
}

std::array<std::vector<double>, 3> tiltValues(const study::TiltStudy& study) {
  std::array<std::vector<double>, 3> values;
  for (const study::TiltRow& row : study.rows) {
    if (std::isnan(row.interval)) continue;
    values[0].push_back(row.tilt);
    values[1].insert(values[1].end(), {row.interval, row.law});
    values[2].push_back(std::fabs(row.ratio() - 1));
  }
  return values;
}

}  // namespace

std::string precisionPlot(const std::string& title, const study::PrecisionStudy& study) {
  const auto [h, error, time] = shownValues(study);
  const PlotPanel steps{{0.075, 0.415}, logarithmicRange(h), logarithmicRange(error)};
  const PlotPanel times{{0.44, 0.78}, logarithmicRange(time), logarithmicRange(error)};
  const std::set<int> slopes = slopesOf(study);
  return dataBlocks(study) + sheetText() + "set logscale xy\nset format '10^{%T}'\n" +
         panelText(steps) + titleText(title) + slopeLines(steps, slopes, 1) +
         "set xlabel 'step  [s]'\nset ylabel 'largest attitude error  [degrees]'\n" +
         precisionSeries(study, 1) + panelText(times) + slopeLines(times, slopes, -1) +
         "set xlabel 'computing time for a second of motion  [ns]'\n"
         "unset ylabel\nset format y ''\n"
         "set key at screen 0.79,0.87 left top Left reverse noenhanced spacing 1.5 samplen 2.5 "
         "font ',12'\n"
         "set label 2 'with the fitted order' at screen 0.795,0.885 left font ',11'\n" +
         slopesLabel(slopes) + precisionSeries(study, 3) + "unset multiplot\n";
}

std::string tiltPlot(const std::string& title, const study::TiltStudy& study) {
  const auto [tilt, interval, difference] = tiltValues(study);
  const PlotPanel intervals{{0.075, 0.475},
                            logarithmicRange(tilt),
                            {0, 1.15 * *std::max_element(interval.begin(), interval.end())}};
  const PlotPanel differences{{0.57, 0.97}, logarithmicRange(tilt), logarithmicRange(difference)};
  return tiltData(study) + sheetText() + "set logscale x\nset format x '10^{%T}'\n" +
         panelText(intervals) + titleText(title) +
         "set xlabel 'tilt  [rad]'\nset ylabel 'time from a flip to the next  [s]'\n"
         "set key top right Left reverse spacing 1.4 samplen 2.5 font ',12'\n"
         "plot $tilts using 1:3 smooth unique with lines linewidth 1.6 linecolor rgb '#d55e00' "
         "title 'logarithmic law', $tilts using 1:2 with points pointtype 7 pointsize "
         "1.1*point_size "
         "linecolor rgb '#0072b2' title 'measured'\n" +
         panelText(differences) + slopeLine(differences, 2) +
         "set label 'grey: slope 2' at graph 0.04,0.95 left textcolor rgb '#808080' font ',11'\n"
         "set key off\nset logscale y\nset format y '10^{%T}'\n"
         "set ylabel '| measured / law − 1 |'\n"
         "plot $tilts using 1:4 smooth unique" +
         seriesStyle("#0072b2", 7) + " notitle\nunset multiplot\n";
}

}  // namespace rotatebook::picture
