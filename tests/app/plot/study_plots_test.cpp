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
#include "scene/scene_text.h"

namespace rotatebook::plot {
namespace {

using physics::Integrator;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
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

study::PrecisionStudy studyOf(const std::vector<study::PrecisionRow>& rows,
                              const std::vector<study::IntegratorOrder>& orders) {
  return {rows, orders};
}

/// Draws a plot, whose texts must be apart and on the sheet; returns them.
std::vector<std::string> textsOn(const Plot& plot) {
  const Drawing drawing = drawPlot(plot, overlay::Typesetter());
  expectTextsApart(drawing);
  std::vector<std::string> texts;
  for (const Written& written : drawing.texts()) texts.push_back(written.text);
  return texts;
}

TEST(PrecisionPlot, NamesIntegratorsOrdersAndAxes) {
  const auto study = studyOf({row(Integrator::Rk4, 0.1, 1), row(Integrator::Rk4, 0.01, 1e-4),
                              row(Integrator::Midpoint, 0.1, 2), failed(Integrator::Midpoint, 1)},
                             {{Integrator::Rk4, {4.0, 2, 0.01, 0.1}}, {Integrator::Midpoint, {}}});
  EXPECT_THAT(
      textsOn(plotOf(study, {})),
      IsSupersetOf({"rk4  4.00", "midpoint  –", "fitted order", "step  [s] →",
                    "↑ largest attitude error  [degrees]",
                    "computing time for a second of motion  [ns] →", "slope 4", "0.1", "10⁻³"}));
}

TEST(PrecisionPlot, HasEachRunAtItsStepItsTimeAndItsError) {
  auto study = studyOf({row(Integrator::Rk4, 0.2, 0.3), row(Integrator::Rk4, 0.01, 4e-5),
                        row(Integrator::Midpoint, 0.05, 2), row(Integrator::Midpoint, 0.02, 0.5),
                        failed(Integrator::Midpoint, 1), row(Integrator::Midpoint, 0.01, 0)},
                       {{Integrator::Rk4, {}}, {Integrator::Midpoint, {}}});
  study.rows[3].nsPerStep = 700;
  const Plot plot = plotOf(study, {});
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
TEST(PrecisionPlot, HasGuidesOfTheRoundedOrders) {
  const auto study =
      studyOf({row(Integrator::Midpoint, 0.1, 1), row(Integrator::Midpoint, 0.001, 1e-4)},
              {{Integrator::Midpoint, {1.93, 2, 0.01, 0.1}}});
  const Plot plot = plotOf(study, {});
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

TEST(PrecisionPlot, IsDrawnOfOneRunAndWithoutAnyError) {
  const std::vector<study::IntegratorOrder> orders{{Integrator::Euler, {}}};
  const Plot one = plotOf(studyOf({row(Integrator::Euler, 0.1, 1)}, orders), {});
  EXPECT_THAT(one.legend, IsEmpty());
  EXPECT_THAT(textsOn(one), IsSupersetOf({"fitted order", "0.1"}));
  EXPECT_THAT(textsOn(plotOf(studyOf({row(Integrator::Euler, 0.1, 0)}, orders), {})),
              IsSupersetOf({"euler  –"}));
}

TEST(PrecisionPlot, HasALookOfItsOwnForEveryIntegratorOfAModel) {
  for (const physics::Model model : {physics::Model::Particles, physics::Model::Quaternion}) {
    study::PrecisionStudy study;
    for (const Integrator integrator : physics::integratorsOf(model)) {
      study.rows.push_back(row(integrator, 0.1, 1));
      study.orders.push_back({integrator, {1.0, 2, 0.01, 0.1}});
    }
    const Plot plot = plotOf(study, {});
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
}

TEST(TiltPlot, HasMeasuredAndLawAtTheirTilts) {
  study::TiltStudy study;
  study.rows = {{0.2, {}, 4, 2.0, 2.1},
                {0.03, {}, 4, 3.5, 3.4},
                {0.01, {study::RunEnd::Kind::FewFlips}},
                {0.001, {}, 4, 5.0, 5.0}};
  const Plot plot = plotOf(study, {});
  EXPECT_THAT(textsOn(plot), IsSupersetOf({"logarithmic law", "measured", "tilt  [rad] →",
                                           "↑ time from a flip to the next  [s]",
                                           "↑ | measured / law − 1 |", "slope 2"}));
  ASSERT_EQ(plot.panels.size(), 2U);
  EXPECT_THAT(plot.panels[0].series[0].points,
              ElementsAre(Point(0.001, 5), Point(0.03, 3.4), Point(0.2, 2.1)));
  EXPECT_THAT(plot.panels[0].series[1].points,
              ElementsAre(Point(0.001, 5), Point(0.03, 3.5), Point(0.2, 2)));
  EXPECT_THAT(plot.panels[1].series[0].points,
              ElementsAre(Point(0.03, std::abs(3.5 / 3.4 - 1)), Point(0.2, std::abs(2 / 2.1 - 1))));
  EXPECT_EQ(plot.panels[0].x.scale, scene::Scale::Logarithmic);
  EXPECT_EQ(plot.panels[0].y.from, 0);
}

TEST(TiltPlot, IsDrawnOfOneTiltThatKeepsTheLaw) {
  study::TiltStudy study;
  study.rows = {{0.1, {}, 4, 2.0, 2.0}};
  EXPECT_THAT(textsOn(plotOf(study, {})), IsSupersetOf({"measured"}));
}

scene::Sweep sweepOver(const scene::Axis& axis, const std::vector<scene::Measure>& measures) {
  scene::Sweep sweep;
  sweep.x = axis;
  sweep.measures = measures;
  return sweep;
}

scene::StudySettings settingsOf(const scene::Sweep& sweep) {
  scene::StudySettings settings;
  settings.sweep = sweep;
  return settings;
}

TEST(SweepPlot, HasACurveForEachValueAndMarksMotionsThatHold) {
  scene::Sweep sweep = sweepOver({"simulation.stiffness", {{"1", "1", 1}, {"100", "100", 100}}},
                                 {scene::Measure::DivergesAt, scene::Measure::EnergyRatio});
  sweep.curves = {"simulation.model", {{"", "matrix"}, {"", "quaternion"}}};
  study::SweepStudy study;
  for (const char* model : {"matrix", "quaternion"}) {
    study.rows.push_back(
        {"1", model, {study::RunEnd::Kind::Diverged, 2}, 20, {2, study::kNoNumber}});
    study.rows.push_back({"100", model, {}, 20, {std::numeric_limits<double>::infinity(), 3}});
  }
  const Plot plot = plotOf(study, settingsOf(sweep));
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

TEST(SweepPlot, HasAPlaceForEachWord) {
  const scene::Sweep sweep =
      sweepOver({"simulation.model", {{"", "matrix"}, {"", "a long name that takes two lines"}}},
                {scene::Measure::Stretch, scene::Measure::ErrorDeg, scene::Measure::TiltDeg,
                 scene::Measure::HalfTurns, scene::Measure::EnergyRatio});
  study::SweepStudy study;
  study.rows = {{"matrix", "", {}, 20, {4e-6, 1, 2, 3, 4}},
                {"a long name that takes two lines", "", {}, 20, {0.5, 1, 2, 3, 4}}};
  const Plot plot = plotOf(study, settingsOf(sweep));
  EXPECT_THAT(textsOn(plot), IsSupersetOf({"matrix", "a long name that takes two lines"}));
  EXPECT_FALSE(plot.panels[0].series[0].hasLine);
}

TEST(SweepPlot, IsDrawnWithoutAnyResult) {
  const scene::Sweep sweep =
      sweepOver({"simulation.substeps", {{"1", "1", 1}}}, {scene::Measure::Stretch});
  study::SweepStudy study;
  study.rows = {{"1", "", {study::RunEnd::Kind::Diverged, 2}, 20, {study::kNoNumber}}};
  EXPECT_THAT(textsOn(plotOf(study, settingsOf(sweep))),
              IsSupersetOf({"1", "simulation.substeps →"}));
}

TEST(StudyLetters, AreRequiredOfTheSceneAndItsValues) {
  scene::Scene scene = scene::parseScene(
      "title = 'T'\n[initial]\nangular_velocity = [5, 0, 0]\n[study]\n"
      "x = { key = 'simulation.model', values = ['matrix', 'quaternion'] }\n"
      "measure = ['error_deg']\n",
      "s.toml");
  requireStudyLetters(scene, *scene.study);
  scene.study->sweep->x.values[1].label = "\xe4\xb8\xad";
  EXPECT_THROW(requireStudyLetters(scene, *scene.study), InputError);
}

}  // namespace
}  // namespace rotatebook::plot
