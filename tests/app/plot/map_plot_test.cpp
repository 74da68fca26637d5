// Pictures of maps: palettes, ticks, contours, and a golden of the whole.
#include "plot/map_plot.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/golden.h"
#include "plot/apart.h"
#include "plot/drawing.h"
#include "plot/map_colours.h"
#include "plot/plot.h"
#include "scene/scene_text.h"

namespace rotatebook::plot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

/// A map of 40 x 24 runs, of which some are of each kind, with a mark and contours.
scene::Scene mapScene(const std::string& more = "") {
  return scene::parseScene(
      "title = 'Every body there is'\ncaption = 'A caption that says what to see.'\n"
      "[simulation]\nmodel = 'exact'\n[initial]\nangular_velocity = [5, 0, 0]\n[map]\n"
      "x = { key = 'moments.smallest', from = 0, to = 1, label = 'smallest / largest' }\n"
      "y = { key = 'moments.middle', from = 0.5, to = 1, label = 'median / largest' }\n"
      "size = [40, 24]\nmeasure = 'growth'\n" +
          (more.empty() ? "colors = { palette = 'viridis', from = 0, to = 1, contours = [0.3] }\n"
                          "marks = [{ moments = [1, 2.3, 3.1], label = 'book' }]\n"
                        : more),
      "bodies.toml");
}

study::MapResult resultOf(const scene::Scene& scene) {
  const study::MapRuns runs(scene);
  study::MapResult result = emptyResult(scene, runs);
  for (const study::MapTile& tile : runs.tiles()) {
    putTile(tile, runs.valuesOf(tile), *scene.map, result);
  }
  return result;
}

double luminanceOf(const Rgb& colour) {
  return rotatebook::luminanceOf(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

// Colours at the quarters of the tables that matplotlib 3.6.3 has. [of 255]
struct PaletteTwin {
  scene::Palette palette;
  std::vector<Rgb> quarters;
};

TEST(Palettes, AreTheFields) {
  using enum scene::Palette;
  const std::vector<PaletteTwin> twins{
      {Inferno, {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}}},
      {Viridis, {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}},
      {Gray, {{0, 0, 0}, {64, 64, 64}, {128, 128, 128}, {192, 192, 192}, {255, 255, 255}}},
      {Coolwarm, {{59, 76, 192}, {141, 176, 254}, {221, 220, 220}, {244, 152, 122}, {180, 4, 38}}}};
  constexpr int kBound = 1;  // of 255, as 33 of 256 colours are stated; measured 1
  for (const PaletteTwin& twin : twins) {
    for (std::size_t i = 0; i < twin.quarters.size(); ++i) {
      const Rgb found = colourAt(twin.palette, static_cast<double>(64 * i) / 255);
      const Rgb& known = twin.quarters[i];
      EXPECT_LE(std::abs(found.red - known.red), kBound) << i;
      EXPECT_LE(std::abs(found.green - known.green), kBound) << i;
      EXPECT_LE(std::abs(found.blue - known.blue), kBound) << i;
    }
  }
}

TEST(Palettes, GrowLighterAllTheWay) {
  using enum scene::Palette;
  for (const auto palette : {Inferno, Viridis, Gray}) {
    const auto light = [&](double share) { return luminanceOf(colourAt(palette, share)); };
    for (int i = 1; i <= 50; ++i) EXPECT_GT(light(i / 50.0), light((i - 1) / 50.0)) << i;
    EXPECT_EQ(colourAt(palette, -3), colourAt(palette, 0));
    EXPECT_EQ(colourAt(palette, 7), colourAt(palette, 1));
  }
}

TEST(Palettes, DivergeFromTheLightestInTheMiddle) {
  const auto light = [](double share) {
    return luminanceOf(colourAt(scene::Palette::Coolwarm, share));
  };
  for (int i = 1; i <= 25; ++i) {
    EXPECT_GT(light(i / 50.0), light((i - 1) / 50.0)) << i;
    EXPECT_GT(light(1 - i / 50.0), light(1 - (i - 1) / 50.0)) << i;
  }
}

TEST(MapColouring, HasColoursOfItsOwnForRunsWithoutANumber) {
  const MapColouring colouring({}, {.runs = 2, .smallest = 1, .largest = 3});
  EXPECT_EQ(colouring.of(study::kNever), kNeverColour);
  EXPECT_EQ(colouring.of(study::kDiverged), kDivergedColour);
  EXPECT_EQ(colouring.of(study::kRefused), kRefusedColour);
  EXPECT_EQ(colouring.of(1), colourAt(scene::Palette::Inferno, 0));
  EXPECT_EQ(colouring.of(3), colourAt(scene::Palette::Inferno, 1));
  EXPECT_EQ(colouring.shareOf(2), 0.5);
  const MapColouring reversed({.reversed = true}, {.runs = 2, .smallest = 1, .largest = 3});
  EXPECT_EQ(reversed.of(1), colouring.of(3));
}

TEST(MapColouring, TakesMapsOfOneValueAndOfNone) {
  EXPECT_EQ(MapColouring({}, {.runs = 1, .smallest = 2, .largest = 2}).shareOf(2), 0);
  EXPECT_EQ(MapColouring({}, {.runs = 1, .refused = 1}).to(), 1);
  scene::MapColours logarithmic;
  logarithmic.scale = scene::Scale::Logarithmic;
  EXPECT_EQ(MapColouring(logarithmic, {.runs = 1, .smallest = 0, .largest = 10}).shareOf(0), 0);
}

std::vector<std::string> labelsOf(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticks) {
    if (!tick.label.empty()) labels.push_back(tick.label);
  }
  return labels;
}

TEST(MapTicks, AreRoundNumbers) {
  using scene::Scale;
  EXPECT_THAT(labelsOf(ticksOf(0, 20, Scale::Linear, 5)), ElementsAre("0", "5", "10", "15", "20"));
  EXPECT_THAT(labelsOf(ticksOf(-180, 180, Scale::Linear, 4)), ElementsAre("−100", "0", "100"));
  EXPECT_THAT(labelsOf(ticksOf(1e-3, 2, Scale::Logarithmic, 5)),
              ElementsAre("0.001", "0.01", "0.1", "1"));
  EXPECT_THAT(labelsOf(ticksOf(1e-12, 1, Scale::Logarithmic, 4)),
              ElementsAre("10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "1"));
  EXPECT_THAT(labelsOf(ticksOf(0.15, 0.9, Scale::Logarithmic, 5)), ElementsAre("0.2", "0.5"));
  EXPECT_THAT(labelsOf(ticksOf(-180, 180, Scale::Linear, 4, true)),
              ElementsAre("−180", "−90", "0", "90", "180"));
  EXPECT_EQ(tickText(2.5e-7), "2.5·10⁻⁷");
}

TEST(MapContours, LieWhereTheValueIs) {
  const std::vector<double> values{0, 1, 2, 0, 1, 2};  // 3 x 2
  const auto pairs = contourOf(values, 3, 2, 0.5);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0], overlay::Point(0.5, 0));
  EXPECT_EQ(pairs[1], overlay::Point(0.5, 1));
  EXPECT_TRUE(contourOf({0, study::kRefused, 2, 0, 1, 2}, 3, 2, 0.5).empty());
}

TEST(PlainMap, HasAPixelForEachRunWithTheFirstRowAtTheBottom) {
  const scene::Scene scene = mapScene();
  const study::MapResult result = resultOf(scene);
  const image::Image picture = plainMap(result, *scene.map);
  EXPECT_EQ(picture.width(), 40);
  EXPECT_EQ(picture.height(), 24);
  const MapColouring colouring(scene.map->colours, factsOf(result));
  for (const auto& [x, y] : {std::pair{0, 0}, {20, 23}, {39, 12}}) {
    const Rgb expected = colouring.of(result.values[0][static_cast<std::size_t>(y * 40 + x)]);
    const std::uint8_t* byte = picture.row(23 - y) + 3 * x;
    EXPECT_EQ((Rgb{byte[0], byte[1], byte[2]}), expected);
  }
}

bool matches(const scene::Scene& scene) {
  const image::Image picture = mapPicture(resultOf(scene), scene);
  const image::Image golden = image::testing::golden("map");
  if (picture.width() != golden.width() || picture.height() != golden.height()) return false;
  return image::compare(golden.view(), picture.view(), kOtherFonts).same;
}

TEST(MapGolden, IsMatched) {
  const image::Image picture = mapPicture(resultOf(mapScene()), mapScene());
  if (image::testing::updatingGoldens()) image::testing::updateGolden("map", picture.view());
  EXPECT_TRUE(image::testing::matchesGolden("map", picture.view(), kOtherFonts));
}

TEST(MapGolden, IsNotMatchedByOtherColoursOrMarks) {
  EXPECT_FALSE(matches(mapScene("colors = { palette = 'gray', from = 0, to = 1 }\n")));
  scene::Scene moved = mapScene();
  moved.map->marks[0].x = 0.6;
  EXPECT_FALSE(matches(moved));
}

TEST(MapPlot, NamesItsAxesAndKeepsItsTextsApart) {
  scene::Scene scene = mapScene();
  scene.map->y.label.clear();
  scene.map->y.key = "initial.tilt.0";
  const Drawing drawing = drawMap(resultOf(scene), scene);
  std::vector<std::string> texts;
  for (const Written& written : drawing.texts()) texts.push_back(written.text);
  EXPECT_THAT(
      texts, IsSupersetOf({"Every body there is", "smallest / largest →", "↑ initial.tilt.0  [rad]",
                           "no such body", "A caption that says what to see."}));
  expectTextsApart(drawing);
}

TEST(MapPlot, IsDrawnOfFewColumnsOfManyRows) {
  for (const int rows : {97, 9000}) {
    scene::Scene scene = mapScene();
    scene.map->width = 2;
    scene.map->height = rows;
    EXPECT_GE(mapPicture(resultOf(scene), scene, 0).height(), rows);
  }
}

TEST(MapPlot, RefusesLettersThatTheFontLacks) {
  scene::Scene scene = mapScene();
  requireMapLetters(scene);
  scene.map->x.label = "\xe4\xb8\xad";
  EXPECT_THROW(requireMapLetters(scene), InputError);
}

}  // namespace
}  // namespace rotatebook::plot
