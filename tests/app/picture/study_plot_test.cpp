// Plots that gnuplot draws without a word, whatever the study.
#include "picture/study_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/png_file.h"
#include "picture/gnuplot.h"
#include "pipeline/small_clip.h"

namespace rotatebook::picture {
namespace {

using physics::Integrator;
using pipeline::testing::bytesOf;
using pipeline::testing::emptyFolder;
using ::testing::HasSubstr;
using ::testing::Not;

study::PrecisionRow row(Integrator integrator, double h, double errorDeg) {
  study::PrecisionRow result;
  result.integrator = integrator;
  result.h = h;
  result.errorDeg = errorDeg;
  result.nsPerStep = 100;
  return result;
}

study::PrecisionRow failed(Integrator integrator, double h) {
  study::PrecisionRow result;
  result.integrator = integrator;
  result.h = h;
  result.end = {study::RunEnd::Kind::NoConvergence};
  return result;
}

/// Draws `plot` and returns the SVG.
std::string drawn(const std::string& plot) {
  const auto folder = emptyFolder();
  drawPlot(plot, folder / "a.svg", folder / "a.png");
  return bytesOf(folder / "a.svg");
}

using Place = Eigen::Vector2d;  // on the sheet, from its top left [pixels]

// Of hundredths of a pixel, as gnuplot writes ticks and points. measured 0.0094
constexpr double kSheetBound = 0.05;

/// Values that an axis names, and where their ticks are; all others lie in line with them.
class Axis {
 public:
  explicit Axis(bool logarithmic = true) : logarithmic_(logarithmic) {}

  void add(double value, double place) { places_[scaled(value)] = place; }
  double placeOf(double value) const {
    if (places_.size() < 2) throw std::runtime_error("an axis names fewer than two values");
    const auto [low, first] = *places_.begin();
    const auto [high, last] = *places_.rbegin();
    return first + (scaled(value) - low) / (high - low) * (last - first);
  }

 private:
  double scaled(double value) const { return logarithmic_ ? std::log10(value) : value; }

  bool logarithmic_;
  std::map<double, double> places_;
};

/// One of a sheet's panels, between these edges [pixels], as it is read back from the SVG.
struct DrawnPanel {
  double left, right;
  Axis x{}, y{};
  /// In the order of the legend: the markers of each series, or the corners of its line.
  std::vector<std::vector<Place>> markers{}, corners{};

  Place placeOf(double across, double up) const { return {x.placeOf(across), y.placeOf(up)}; }
};

/// Returns the number in `label`: "0.5", or 10 to the power in small type; NaN for others.
double numberIn(const std::string& label) {
  static const std::regex kPower(">10</tspan><tspan[^>]*>(-?[0-9]+)</tspan>");
  static const std::regex kPlain("> *(-?[0-9.]+)</tspan>");
  std::smatch match;
  if (std::regex_search(label, match, kPower)) return std::pow(10, std::stod(match[1]));
  return std::regex_search(label, match, kPlain) ? std::stod(match[1]) : std::nan("");
}

/// Reads `panel` out of what gnuplot drew.
void readPanel(const std::string& svg, DrawnPanel& panel) {
  // A tick, which starts at its axis, and its label, which is on the next line.
  static const std::regex kTick(
      "d='M([0-9.]+),([0-9.]+) [^']*'/>\\s*<g .*text-anchor=\"(end|middle)");
  static const std::regex kMarker("<use [^>]*translate\\(([0-9.]+),([0-9.]+)\\)");
  static const std::regex kCorner("[ML]([0-9.]+),([0-9.]+)");
  const auto isAcross = [&](double x) { return panel.left - 1 <= x && x <= panel.right + 1; };
  std::istringstream lines(svg);
  bool inSeries = false;
  const auto add = [&](const std::string& line, const std::regex& pattern,
                       std::vector<Place>& places) {
    for (std::sregex_iterator match(line.begin(), line.end(), pattern), end; match != end;
         ++match) {
      const Place place(std::stod((*match)[1]), std::stod((*match)[2]));
      if (isAcross(place.x())) places.push_back(place);
    }
  };
  for (std::string line; std::getline(lines, line);) {
    std::smatch tick;
    if (std::regex_search(line, tick, kTick)) {
      const Place place(std::stod(tick[1]), std::stod(tick[2]));
      const bool ofX = tick[3] == "middle";
      std::getline(lines, line);
      const double value = numberIn(line);
      if (std::isnan(value)) continue;
      if (ofX && isAcross(place.x())) panel.x.add(value, place.x());
      if (!ofX && std::abs(place.x() - panel.left) < 1) panel.y.add(value, place.y());
    }
    if (line.find(" Z ") != line.npos) inSeries = false;  // the frame around a panel
    if (line.find("id=\"gnuplot_plot_") != line.npos) {
      inSeries = true;
      panel.markers.emplace_back();
      panel.corners.emplace_back();
    }
    if (!inSeries) continue;
    add(line, kMarker, panel.markers.back());
    add(line, kCorner, panel.corners.back());
  }
  // Remove those of the sheet's other panel.
  std::erase_if(panel.markers, [](const auto& series) { return series.empty(); });
  std::erase_if(panel.corners, [](const auto& series) { return series.empty(); });
}

void expectPlaces(const std::vector<Place>& found, const std::vector<Place>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT((found[i] - expected[i]).norm(), kSheetBound)
        << "point " << i << " is at (" << found[i].transpose() << "), not at ("
        << expected[i].transpose() << ")";
  }
}

TEST(PrecisionPlot, NamesIntegratorsOrdersAndAxes) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Rk4, 0.1, 1), row(Integrator::Rk4, 0.01, 1e-4),
                row(Integrator::Midpoint, 0.1, 2), failed(Integrator::Midpoint, 1)};
  study.orders = {{Integrator::Rk4, {4.0, 2, 0.01, 0.1}}, {Integrator::Midpoint, {}}};
  const std::string svg = drawn(precisionPlot("A title", study));
  for (const char* label :
       {"A title", "rk4  4.00", "midpoint  –", "step  [s]", "largest attitude error  [degrees]",
        "computing time for a second of motion  [ns]", "grey: slopes 4"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
}

// 1200 pixels across: panels from 0.075 to 0.415 and from 0.44 to 0.78 of it.
TEST(PrecisionPlot, HasEachRunAtItsStepItsTimeAndItsError) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Rk4, 0.2, 0.3), row(Integrator::Rk4, 0.01, 4e-5),
                row(Integrator::Midpoint, 0.05, 2), row(Integrator::Midpoint, 0.02, 0.5)};
  study.rows[3].nsPerStep = 700;
  study.orders = {{Integrator::Rk4, {}}, {Integrator::Midpoint, {}}};
  const std::string svg = drawn(precisionPlot("Where", study));
  DrawnPanel steps{.left = 90, .right = 498}, times{.left = 528, .right = 936};
  readPanel(svg, steps);
  readPanel(svg, times);
  ASSERT_EQ(steps.markers.size(), 2U);
  ASSERT_EQ(times.markers.size(), 2U);
  times.y = steps.y;  // Its own has no labels.
  for (std::size_t i : {0U, 1U}) {
    std::vector<Place> byStep, byTime;
    for (const std::size_t j : {2 * i, 2 * i + 1}) {
      const study::PrecisionRow& one = study.rows[j];
      byStep.push_back(steps.placeOf(one.h, one.errorDeg));
      byTime.push_back(times.placeOf(one.nsPerStep / one.h, one.errorDeg));
    }
    expectPlaces(steps.markers[i], byStep);
    expectPlaces(steps.corners[i], byStep);
    expectPlaces(times.markers[i], byTime);
    expectPlaces(times.corners[i], byTime);
  }
  EXPECT_GT(steps.y.placeOf(1e-4), steps.y.placeOf(1)) << "what is more is higher";
  EXPECT_LT(steps.x.placeOf(0.01), steps.x.placeOf(0.1));
}

TEST(PrecisionPlot, IsDrawnOfOneRun) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Euler, 0.1, 1)};
  study.orders = {{Integrator::Euler, {}}};
  EXPECT_THAT(drawn(precisionPlot("One", study)), Not(HasSubstr("grey: slopes")));
}

TEST(PrecisionPlot, IsDrawnWithoutAnyError) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Euler, 0.1, 0), row(Integrator::Euler, 0.2, 0)};
  study.orders = {{Integrator::Euler, {}}};
  EXPECT_THAT(drawn(precisionPlot("None", study)), HasSubstr("euler"));
}

TEST(PrecisionPlot, TakesTitlesOfAnyLetters) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Euler, 0.1, 1)};
  study.orders = {{Integrator::Euler, {}}};
  const std::string svg = drawn(precisionPlot("It's\n\"x_{1}^2\" \\ `é` @ & %d", study));
  EXPECT_THAT(svg, HasSubstr("It’s \"x_{1}^2\" \\ `é` @ &amp; %d"));
}

TEST(PrecisionPlot, ShortensTitlesThatAreTooLongForTheSheet) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Euler, 0.1, 1)};
  study.orders = {{Integrator::Euler, {}}};
  std::string title;
  for (int i = 0; i < 90; ++i) title += "é";
  EXPECT_THAT(precisionPlot(title, study), HasSubstr("'" + title +
                                                     "' at screen 0.5,0.95 center "
                                                     "noenhanced font ',17'"));
  for (int i = 0; i < 60; ++i) title += "ü";
  EXPECT_THAT(precisionPlot(title, study), HasSubstr("'" + title +
                                                     "' at screen 0.5,0.95 center "
                                                     "noenhanced font ',10.5'"));
  EXPECT_THAT(precisionPlot(title + "ü", study), HasSubstr("'" + title + "…'"));
}

TEST(PrecisionPlot, HasAStyleOfItsOwnForEveryIntegratorOfAModel) {
  for (const physics::Model model : {physics::Model::Particles, physics::Model::Quaternion}) {
    study::PrecisionStudy study;
    for (const Integrator integrator : physics::integratorsOf(model)) {
      study.rows.push_back(row(integrator, 0.1, 1));
      study.orders.push_back({integrator, {}});
    }
    const std::string plot = precisionPlot("All", study);
    std::set<std::string> colours, points;
    for (std::size_t i = 0; i < study.orders.size(); ++i) {
      const std::string curve = "$runs" + std::to_string(i) + " using 1:2 with linespoints ";
      const std::string style = plot.substr(plot.find(curve) + curve.size(), 80);
      colours.insert(style.substr(style.find("rgb '"), 13));
      points.insert(style.substr(style.find("pointtype "), 13));
    }
    EXPECT_EQ(colours.size(), study.orders.size());
    EXPECT_EQ(points.size(), study.orders.size());
  }
}

TEST(TiltPlot, ShowsMeasuredAndLaw) {
  study::TiltStudy study;
  study.rows = {
      {0.1, {}, 4, 2.0, 2.1}, {0.01, {}, 4, 3.0, 3.01}, {0.001, {study::RunEnd::Kind::FewFlips}}};
  const std::string svg = drawn(tiltPlot("Tilts", study));
  for (const char* label : {"Tilts", "logarithmic law", "measured", "tilt  [rad]",
                            "time from a flip to the next  [s]", "| measured / law − 1 |"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
}

TEST(TiltPlot, HasMeasuredAndLawAtTheirTilts) {
  study::TiltStudy study;
  study.rows = {{0.2, {}, 4, 2.0, 2.1}, {0.03, {}, 4, 3.5, 3.4}, {0.001, {}, 4, 5.0, 5.001}};
  const std::string svg = drawn(tiltPlot("Where", study));
  DrawnPanel intervals{.left = 90, .right = 570}, differences{.left = 684, .right = 1164};
  intervals.y = Axis(false);
  readPanel(svg, intervals);
  readPanel(svg, differences);
  std::vector<Place> measured, law, difference;
  for (const study::TiltRow& one : study.rows) {
    measured.push_back(intervals.placeOf(one.tilt, one.interval));
    law.push_back(intervals.placeOf(one.tilt, one.law));
    difference.push_back(differences.placeOf(one.tilt, std::abs(one.interval / one.law - 1)));
  }
  // Lines are drawn from left to right; in the legend are two corners and, at the end, a marker.
  std::ranges::reverse(law);
  std::vector<Place>& line = intervals.corners.at(0);
  ASSERT_EQ(line.size(), 2 + 3U);
  line.erase(line.begin(), line.begin() + 2);
  expectPlaces(line, law);
  std::vector<Place>& dots = intervals.markers.at(0);
  ASSERT_EQ(dots.size(), 3 + 1U);
  dots.pop_back();
  expectPlaces(dots, measured);
  std::ranges::reverse(difference);
  expectPlaces(differences.markers.at(0), difference);
}

TEST(TiltPlot, IsDrawnOfOneTiltThatKeepsTheLaw) {
  study::TiltStudy study;
  study.rows = {{0.1, {}, 4, 2.0, 2.0}};
  EXPECT_THAT(drawn(tiltPlot("One", study)), HasSubstr("measured"));
}

TEST(SweepPlot, HasACurveForEachValueAndMarksMotionsThatHold) {
  scene::Sweep sweep;
  sweep.over = {"simulation.substeps", {{"1", "1", 1}, {"100", "100", 100}}};
  sweep.curves = {"simulation.model", {{"", "matrix"}, {"", "quaternion"}}};
  sweep.measures = {scene::Measure::DivergesAt, scene::Measure::ErrorDeg};
  study::SweepStudy study;
  for (const char* model : {"matrix", "quaternion"}) {
    study.rows.push_back(
        {"1", model, {study::RunEnd::Kind::Diverged, 2}, 20, {2, study::kNoNumber}});
    study.rows.push_back({"100", model, {}, 20, {std::numeric_limits<double>::infinity(), 3}});
  }
  const std::string plot = sweepPlot("Which holds?", study, sweep);
  EXPECT_THAT(plot, HasSubstr("$m0_0_open << END\n100 20\nEND"));
  const std::string svg = drawn(plot);
  for (const char* words : {"Which holds?", "matrix", "quaternion", "simulation.substeps",
                            "not within the run", "diverges at"}) {
    EXPECT_THAT(svg, HasSubstr(words));
  }
}

TEST(SweepPlot, HasAPlaceForEachWord) {
  scene::Sweep sweep;
  sweep.over = {"simulation.model", {{"", "matrix"}, {"", "exact"}}};
  sweep.measures = {scene::Measure::Stretch};
  study::SweepStudy study;
  study.rows = {{"matrix", "", {}, 20, {0.5}}, {"exact", "", {}, 20, {0.0}}};
  const std::string svg = drawn(sweepPlot("Words", study, sweep));
  EXPECT_THAT(svg, HasSubstr("matrix"));
  EXPECT_THAT(svg, HasSubstr("exact"));
}

TEST(SweepPlot, HasRoomForSmallNumbersBesideTheNameOfTheAxis) {
  scene::Sweep sweep;
  sweep.over = {"simulation.substeps", {{"1", "1", 1}, {"2", "2", 2}}};
  sweep.measures = {scene::Measure::Stretch};
  study::SweepStudy study;
  study.rows = {{"1", "", {}, 20, {0.05}}, {"2", "", {}, 20, {4e-6}}};
  const std::string svg = drawn(sweepPlot("Small", study, sweep));
  const std::size_t turned = svg.find(") rotate(270)");
  ASSERT_NE(turned, std::string::npos);
  const std::size_t begin = svg.rfind('(', turned) + 1;
  constexpr double kLetters = 25;  // height of the name of the axis, and a margin [pixels]
  EXPECT_GT(std::stod(svg.substr(begin)), kLetters);  // measured 43.9
}

TEST(SweepPlot, IsDrawnWithoutAnyResult) {
  scene::Sweep sweep;
  sweep.over = {"simulation.substeps", {{"1", "1", 1}}};
  sweep.measures = {scene::Measure::Stretch};
  study::SweepStudy study;
  study.rows = {{"1", "", {study::RunEnd::Kind::Diverged, 2}, 20, {study::kNoNumber}}};
  EXPECT_THAT(drawn(sweepPlot("None", study, sweep)), HasSubstr("None"));
}

}  // namespace
}  // namespace rotatebook::picture
