// Plots that gnuplot draws without a word, whatever the study.
#include "picture/study_plot.h"

#include <string>

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

TEST(PrecisionPlot, NamesIntegratorsOrdersAndAxes) {
  study::PrecisionStudy study;
  study.rows = {row(Integrator::Rk4, 0.1, 1), row(Integrator::Rk4, 0.01, 1e-4),
                row(Integrator::Midpoint, 0.1, 2), failed(Integrator::Midpoint, 1)};
  study.orders = {{Integrator::Rk4, {4.0, 2, 0.01, 0.1}}, {Integrator::Midpoint, {}}};
  const std::string svg = drawn(precisionPlot("A title", study));
  for (const char* words :
       {"A title", "rk4  4.00", "midpoint  –", "step  [s]", "largest attitude error  [degrees]",
        "computing time for a second of motion  [ns]", "grey: slopes 4"}) {
    EXPECT_THAT(svg, HasSubstr(words));
  }
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

TEST(PrecisionPlot, HasAStyleForEveryIntegratorOfEachModel) {
  for (const physics::Model model : {physics::Model::Particles, physics::Model::Quaternion}) {
    study::PrecisionStudy study;
    for (const Integrator integrator : physics::integratorsOf(model)) {
      study.rows.push_back(row(integrator, 0.1, 1));
      study.orders.push_back({integrator, {}});
    }
    const std::string plot = precisionPlot("All", study);
    for (std::size_t i = 0; i < study.orders.size(); ++i) {
      EXPECT_THAT(plot, HasSubstr("$runs" + std::to_string(i) + " using 1:2 with linespoints"));
    }
  }
}

TEST(TiltPlot, ShowsMeasuredAndLaw) {
  study::TiltStudy study;
  study.rows = {
      {0.1, {}, 4, 2.0, 2.1}, {0.01, {}, 4, 3.0, 3.01}, {0.001, {study::RunEnd::Kind::FewFlips}}};
  const std::string svg = drawn(tiltPlot("Tilts", study));
  for (const char* words : {"Tilts", "logarithmic law", "measured", "tilt  [rad]",
                            "time from a flip to the next  [s]", "| measured / law − 1 |"}) {
    EXPECT_THAT(svg, HasSubstr(words));
  }
}

TEST(TiltPlot, IsDrawnOfOneTiltThatKeepsTheLaw) {
  study::TiltStudy study;
  study.rows = {{0.1, {}, 4, 2.0, 2.0}};
  EXPECT_THAT(drawn(tiltPlot("One", study)), HasSubstr("measured"));
}

}  // namespace
}  // namespace rotatebook::picture
