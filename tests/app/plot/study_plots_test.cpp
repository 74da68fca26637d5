// Plots of studies: their curves, axes, legends and notes, whatever the study.
#include "plot/study_plots.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "plot/apart.h"
#include "plot/plot.h"
#include "scene/names.h"
#include "scene/scene_text.h"

namespace rotatebook::plot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

study::StudyRow row(const std::string& curve, double step, double errorDeg) {
  study::StudyRow result{"", curve};
  result.step = step;
  result.measured = {errorDeg};
  result.nsPerStep = 100;
  return result;
}

study::StudyRow failed(const std::string& curve, double step) {
  study::StudyRow result = row(curve, step, study::kNoNumber);
  result.end = {study::RunEnd::Kind::NoConvergence};
  return result;
}

scene::StudySettings ofOrders() {
  scene::StudySettings settings;
  settings.measures = {scene::Measure::Order};
  return settings;
}

/// Draws a plot, whose texts must be apart and on the sheet; returns them.
std::vector<std::string> textsOn(const Plot& plot) {
  const Drawing drawing = drawPlot(plot, overlay::Typesetter());
  expectTextsApart(drawing);
  std::vector<std::string> texts;
  for (const Written& written : drawing.texts()) texts.push_back(written.text);
  return texts;
}

TEST(OrderPlot, NamesIntegratorsOrdersAndAxes) {
  const auto study = study::Study{
      {row("rk4", 0.1, 1), row("rk4", 0.01, 1e-4), row("midpoint", 0.1, 2), failed("midpoint", 1)},
      {{"rk4", {4.0, 2, 0.01, 0.1}}, {"midpoint", {}}}};
  EXPECT_THAT(
      textsOn(plotOf(study, ofOrders())),
      IsSupersetOf({"rk4  4.00", "midpoint  –", "fitted order", "step  [s] →",
                    "↑ largest attitude error  [degrees]",
                    "computing time for a second of motion  [ns] →", "slope 4", "0.1", "10⁻³"}));
}

TEST(OrderPlot, HasEachRunAtItsStepItsTimeAndItsError) {
  auto study =
      study::Study{{row("rk4", 0.2, 0.3), row("rk4", 0.01, 4e-5), row("midpoint", 0.05, 2),
                    row("midpoint", 0.02, 0.5), failed("midpoint", 1), row("midpoint", 0.01, 0)},
                   {{"rk4", {}}, {"midpoint", {}}}};
  study.rows[3].nsPerStep = 700;
  const Plot plot = plotOf(study, ofOrders());
  ASSERT_EQ(plot.panels.size(), 2U);
  EXPECT_THAT(plot.panels[0].series[0].points, ElementsAre(Point(0.2, 0.3), Point(0.01, 4e-5)));
  EXPECT_THAT(plot.panels[0].series[1].points, ElementsAre(Point(0.05, 2), Point(0.02, 0.5)));
  EXPECT_THAT(plot.panels[1].series[1].points,
              ElementsAre(Point(100 / 0.05, 2), Point(700 / 0.02, 0.5)));
  EXPECT_THAT(plot.panels[0].lines, IsEmpty());
  for (const Panel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      for (const Point& point : series.points) {
        EXPECT_TRUE(0 < panel.x.shareOf(point.x()) && panel.x.shareOf(point.x()) < 1);
        EXPECT_TRUE(0 < panel.y.shareOf(point.y()) && panel.y.shareOf(point.y()) < 1);
      }
    }
  }
}

// A line of slope 2 rises by two decades in one, and ends at the edges of its panel.
TEST(OrderPlot, HasGuidesOfTheRoundedOrders) {
  const auto study = study::Study{{row("midpoint", 0.1, 1), row("midpoint", 0.001, 1e-4)},
                                  {{"midpoint", {1.93, 2, 0.01, 0.1}}}};
  const Plot plot = plotOf(study, ofOrders());
  for (const auto& [panel, slope] : {std::pair{plot.panels[0], 2.0}, {plot.panels[1], -2.0}}) {
    ASSERT_EQ(panel.lines.size(), 2U);
    const Point &from = panel.lines[0], &to = panel.lines[1];
    EXPECT_EQ(from.y(), panel.y.to);
    constexpr double kBound = 1e-9;  // measured 4e-16
    EXPECT_NEAR(std::log(to.y() / from.y()) / std::log(to.x() / from.x()), slope, kBound);
    EXPECT_TRUE(std::abs(panel.y.shareOf(to.y())) < kBound ||
                std::abs(panel.x.shareOf(to.x()) - (slope > 0 ? 0 : 1)) < kBound);
  }
}

TEST(OrderPlot, IsDrawnOfOneRunAndWithoutAnyError) {
  const std::vector<study::CurveOrder> orders{{"euler", {}}};
  const Plot one = plotOf(study::Study{{row("euler", 0.1, 1)}, orders}, ofOrders());
  EXPECT_THAT(one.legend, IsEmpty());
  EXPECT_THAT(textsOn(one), IsSupersetOf({"fitted order", "0.1"}));
  EXPECT_THAT(textsOn(plotOf(study::Study{{row("euler", 0.1, 0)}, orders}, ofOrders())),
              IsSupersetOf({"euler  –"}));
}

TEST(OrderPlot, HasALookOfItsOwnForEveryIntegratorOfAModel) {
  study::Study study;
  for (const physics::Integrator integrator : physics::integratorsOf(physics::Model::Quaternion)) {
    const std::string name(scene::nameOf(scene::kIntegrators, integrator));
    study.rows.push_back(row(name, 0.1, 1));
    study.orders.push_back({name, {1.0, 2, 0.01, 0.1}});
  }
  const Plot plot = plotOf(study, ofOrders());
  std::set<std::tuple<double, double, double>> colours;
  std::set<std::tuple<int, double, bool>> shapes;
  for (const auto& [name, marker, points, hasLine, hasMarkers] : plot.panels[0].series) {
    colours.emplace(marker.colour.red, marker.colour.green, marker.colour.blue);
    shapes.emplace(marker.corners, marker.turned, marker.isOpen);
  }
  EXPECT_EQ(colours.size(), study.orders.size());
  EXPECT_EQ(shapes.size(), study.orders.size());
  textsOn(plot);
}

scene::StudySettings studyOver(const scene::Axis& axis,
                               const std::vector<scene::Measure>& measures) {
  scene::StudySettings settings;
  settings.x = axis;
  settings.measures = measures;
  return settings;
}

TEST(StudyPlot, HasACurveForEachValueAndMarksMotionsThatHold) {
  scene::StudySettings settings =
      studyOver({"simulation.stiffness", {{"1", "1", 1}, {"100", "100", 100}}},
                {scene::Measure::DivergesAt, scene::Measure::EnergyRatio});
  settings.curves = {"simulation.model", {{"", "matrix"}, {"", "quaternion"}}};
  study::Study study;
  for (const char* model : {"matrix", "quaternion"}) {
    study.rows.push_back(
        {"1", model, {study::RunEnd::Kind::Diverged, 2}, 20, 0.1, {2, study::kNoNumber}});
    study.rows.push_back({"100", model, {}, 20, 0.1, {std::numeric_limits<double>::infinity(), 3}});
  }
  const Plot plot = plotOf(study, settings);
  ASSERT_EQ(plot.panels.size(), 2U);
  ASSERT_EQ(plot.panels[0].series.size(), 4U);
  EXPECT_THAT(plot.panels[0].series[0].points, ElementsAre(Point(1, 2)));
  EXPECT_THAT(plot.panels[0].series[1].points, ElementsAre(Point(100, 20)));
  EXPECT_TRUE(plot.panels[0].series[1].marker.isOpen);
  EXPECT_THAT(plot.panels[1].series[2].points, ElementsAre(Point(100, 3)));
  EXPECT_THAT(textsOn(plot), IsSupersetOf({"matrix", "quaternion", "simulation.model",
                                           "simulation.stiffness  [N/m] →", "↑ diverges at  [s]",
                                           "↑ largest | E / E₀ − 1 |", "not within the run"}));
}

TEST(StudyPlot, HasAPlaceForEachWord) {
  const scene::StudySettings settings =
      studyOver({"simulation.model", {{"", "matrix"}, {"", "a long name that takes two lines"}}},
                {scene::Measure::Stretch, scene::Measure::ErrorDeg, scene::Measure::TiltDeg,
                 scene::Measure::HalfTurns, scene::Measure::EnergyRatio});
  study::Study study;
  study.rows = {{"matrix", "", {}, 20, 0.1, {4e-6, 1, 2, 3, 4}},
                {"a long name that takes two lines", "", {}, 20, 0.1, {0.5, 1, 2, 3, 4}}};
  const Plot plot = plotOf(study, settings);
  EXPECT_THAT(textsOn(plot), IsSupersetOf({"matrix", "a long name that takes two lines"}));
  EXPECT_FALSE(plot.panels[0].series[0].hasLine);
}

TEST(StudyPlot, IsDrawnWithoutAnyResult) {
  const scene::StudySettings settings =
      studyOver({"simulation.substeps", {{"1", "1", 1}}}, {scene::Measure::Stretch});
  study::Study study;
  study.rows = {{"1", "", {study::RunEnd::Kind::Diverged, 2}, 20, 0.1, {study::kNoNumber}}};
  EXPECT_THAT(textsOn(plotOf(study, settings)), IsSupersetOf({"1", "simulation.substeps →"}));
}

TEST(StudyLetters, AreRequiredOfTheSceneAndItsValues) {
  scene::Scene scene = scene::parseScene(
      "title = 'T'\n[initial]\nangular_velocity = [5, 0, 0]\n[study]\n"
      "x = { key = 'simulation.model', values = ['matrix', 'quaternion'] }\n"
      "measure = ['error_deg']\n",
      "s.toml");
  requireStudyLetters(scene);
  scene.study->x.values[1].label = "\xe4\xb8\xad";
  EXPECT_THROW(requireStudyLetters(scene), InputError);
}

}  // namespace
}  // namespace rotatebook::plot
