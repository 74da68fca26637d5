// How plots are drawn: curves in their places, a legend above them; a golden of the whole.
#include "plot/plot.h"

#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/golden.h"
#include "plot/apart.h"

namespace rotatebook::plot {
namespace {

/// Two panels: one with decades, and one with words and a note.
Plot plotOfTwo() {
  Series first{"first", markerOf(4), {{0.01, 0.02}, {0.1, 0.3}, {1, 3}}};
  const Series second{"second", markerOf(1), {{0.02, 2}, {0.5, 0.5}}};
  Panel decades{"",
                {"step  [s]", 0.005, 2, scene::Scale::Logarithmic},
                {"error  [degrees]", 0.01, 10, scene::Scale::Logarithmic}};
  decades.series = {first, second};
  decades.lines = {{0.005, 0.01}, {2, 4}};
  decades.pen = {{0.66, 0.66, 0.66}, 1};
  first.points = {{1, 3}, {2, 1}};
  first.hasLine = false;
  Panel words{"a name", {.name = "model", .from = 0.5, .to = 2.5}, {"stretch", 0, 4}};
  words.x.words = {{1, "matrix"}, {2, "exact"}};
  words.series = {first};
  words.marks = {{{1.5, 2}, "a mark"}};
  Plot plot{"A plot of two panels", "A caption that says what to see.", "integrator"};
  plot.legend = {{"slope 1", {{0.66, 0.66, 0.66}}, {}, true, false}};
  plot.panels = {decades, words};
  return plot;
}

image::Image pictureOf(const Plot& plot) {
  return drawPlot(plot, overlay::Typesetter()).pixels();
}

TEST(PlotGolden, IsMatched) {
  const image::Image picture = pictureOf(plotOfTwo());
  if (image::testing::updatingGoldens()) image::testing::updateGolden("plot", picture.view());
  EXPECT_TRUE(image::testing::matchesGolden("plot", picture.view(), kOtherFonts));
}

TEST(PlotGolden, IsNotMatchedByOtherPointsNamesOrGuides) {
  const auto matches = [](const Plot& plot) {
    const image::Image picture = pictureOf(plot), golden = image::testing::golden("plot");
    if (picture.width() != golden.width() || picture.height() != golden.height()) return false;
    return image::compare(golden.view(), picture.view(), kOtherFonts).same;
  };
  Plot moved = plotOfTwo();
  moved.panels[0].series[0].points[1].y() = 0.6;
  EXPECT_FALSE(matches(moved));
  Plot renamed = plotOfTwo();
  renamed.panels[0].y.name = "another number than that";
  EXPECT_FALSE(matches(renamed));
  Plot unguided = plotOfTwo();
  unguided.panels[0].lines.clear();
  EXPECT_FALSE(matches(unguided));
}

TEST(Plot, KeepsItsTextsApartAndItsLegendAboveItsPanels) {
  Plot plot = plotOfTwo();
  for (int i = 0; i < 12; ++i) plot.legend.push_back({"item " + std::to_string(i), markerOf(2)});
  const Drawing drawing = drawPlot(plot, overlay::Typesetter());
  expectTextsApart(drawing);
  const auto boxOf = [&](const std::string& text) {
    for (const Written& written : drawing.texts()) {
      if (written.text == text) return written.box;
    }
    ADD_FAILURE() << text;
    return Box{};
  };
  EXPECT_GT(boxOf("second").x, boxOf("first").right());
  EXPECT_GT(boxOf("item 11").y, boxOf("first").bottom()) << "a second row";
  EXPECT_GT(boxOf("↑ error  [degrees]").y, boxOf("item 11").bottom());
  EXPECT_GT(boxOf("model →").y, boxOf("matrix").bottom());
}

TEST(Plot, WrapsATitleThatIsLong) {
  Plot plot = plotOfTwo();
  const double height = drawPlot(plot, overlay::Typesetter()).sheet().height;
  for (int i = 0; i < 30; ++i) plot.title += " and more";
  const Drawing drawing = drawPlot(plot, overlay::Typesetter());
  EXPECT_EQ(drawing.texts().front().text, plot.title);
  EXPECT_GT(drawing.sheet().height, height);
  expectTextsApart(drawing);
}

TEST(Plot, LabelsDecadesAlikeWhereTheirTicksAreSmall) {
  Plot plot = plotOfTwo();
  plot.panels[0].x.from = 1e-7;
  const Drawing drawing = drawPlot(plot, overlay::Typesetter());
  std::vector<std::string> texts;
  for (const Written& written : drawing.texts()) texts.push_back(written.text);
  EXPECT_THAT(texts, ::testing::IsSupersetOf({"10⁻⁶", "10⁻⁴", "10⁻²", "1"}));
}

}  // namespace
}  // namespace rotatebook::plot
