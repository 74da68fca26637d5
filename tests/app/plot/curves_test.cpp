// How curves are drawn: in their places, with a legend beside them; a golden of the whole.
#include "plot/curves.h"

#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/golden.h"
#include "plot/apart.h"

namespace rotatebook::plot {
namespace {

/// Two panels: one with decades, and one with words and a note.
CurvesPlot plotOfTwo() {
  Series first{"first", markerOf(4), {{0.01, 0.02}, {0.1, 0.3}, {1, 3}}};
  const Series second{"second", markerOf(1), {{0.02, 2}, {0.5, 0.5}}};
  CurvesPanel decades{{"step  [s]", 0.005, 2, scene::Scale::Logarithmic},
                      {"error  [degrees]", 0.01, 10, scene::Scale::Logarithmic},
                      false,
                      {first, second},
                      {{0.005, 0.01}, {2, 4}}};
  first.points = {{1, 3}, {2, 1}};
  first.hasLine = false;
  CurvesPanel words{{"model", 0.5, 2.5, scene::Scale::Linear, false, {{1, "matrix"}, {2, "exact"}}},
                    {"stretch", 0, 4},
                    false,
                    {first}};
  return {"Curves of two panels", "grey: slope 1", "integrator", {decades, words}};
}

image::Image pictureOf(const CurvesPlot& plot) {
  return drawCurves(plot, overlay::Typesetter()).pixels();
}

TEST(CurvesGolden, IsMatched) {
  const image::Image picture = pictureOf(plotOfTwo());
  if (image::testing::updatingGoldens()) image::testing::updateGolden("curves", picture.view());
  EXPECT_TRUE(image::testing::matchesGolden("curves", picture.view(), kOtherFonts));
}

TEST(CurvesGolden, IsNotMatchedByOtherPointsNamesOrGuides) {
  const auto matches = [](const CurvesPlot& plot) {
    const image::Image picture = pictureOf(plot), golden = image::testing::golden("curves");
    if (picture.width() != golden.width() || picture.height() != golden.height()) return false;
    return image::compare(golden.view(), picture.view(), kOtherFonts).same;
  };
  CurvesPlot moved = plotOfTwo();
  moved.panels[0].series[0].points[1].y() = 0.6;
  EXPECT_FALSE(matches(moved));
  CurvesPlot renamed = plotOfTwo();
  renamed.panels[0].x.name = "time  [s]";
  EXPECT_FALSE(matches(renamed));
  CurvesPlot unguided = plotOfTwo();
  unguided.panels[0].guides.clear();
  EXPECT_FALSE(matches(unguided));
}

TEST(Curves, KeepTheirLegendOutOfTheirPanels) {
  const Drawing drawing = drawCurves(plotOfTwo(), overlay::Typesetter());
  expectTextsApart(drawing);
  const auto boxOf = [&](const std::string& text) {
    for (const Written& written : drawing.texts()) {
      if (written.text == text) return written.box;
    }
    ADD_FAILURE() << text;
    return Box{};
  };
  // The name of the last axis ends where its panel does.
  EXPECT_GT(boxOf("first").x, boxOf("model →").right());
  EXPECT_GT(boxOf("second").y, boxOf("first").bottom() - 1);
  EXPECT_GE(boxOf("first").y, boxOf("integrator").bottom());
}

TEST(Curves, ShortenNoTitleButWrapIt) {
  CurvesPlot plot = plotOfTwo();
  const double height = drawCurves(plot, overlay::Typesetter()).height();
  for (int i = 0; i < 30; ++i) plot.title += " and more";
  const Drawing drawing = drawCurves(plot, overlay::Typesetter());
  EXPECT_EQ(drawing.texts().front().text, plot.title);
  EXPECT_GT(drawing.height(), height);
  expectTextsApart(drawing);
}

}  // namespace
}  // namespace rotatebook::plot
