// Grids of books: where cells and margins are, and what is in them. image/golden.h says how the
// golden is renewed.
#include "plot/grid_margins.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/golden.h"
#include "messages.h"
#include "picture/frame_drawer.h"
#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {
namespace {

using plot::GridMargins;
using plot::PanelGrid;

// Letters of other versions of the libraries, and books of other drivers, differ in their edges.
constexpr image::Tolerance kGridTolerance{.largest = 40, .failPercent = 0.1};
constexpr const char* kColumns =
    "columns = { key = 'initial.tilt', values = [0.1, 0.01, 0.0001], label = 'tilt [rad]' }\n";
constexpr const char* kRows =
    "rows = { key = 'simulation.model', values = ['quaternion', 'particles'], label = 'model of "
    "the book' }\n";

/// The particles burst at once.
scene::Scene gridScene(const std::string& grid, const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = 'Six books'\ncaption = 'The lower three did not last.'\n"
      "[simulation]\nsubsteps = 1\nnormalize = false\nintegrator = 'euler'\n"
      "[initial]\nangular_velocity = [5, 3, 1]\ntilt = [0.1, 'z']\n"
      "[clip]\nsize = [480, 270]\nfps = 24\nduration = 0.5\n"
      "[overlay]\nshow = ['caption', 'clock']\n[grid]\n" +
          grid,
      "grid.toml", overrides);
}

image::Image drawnGrid(const scene::Scene& scene, std::vector<std::int64_t> frames) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  for (const std::int64_t frame : frames) drawer.draw(frame, picture);
  return picture;
}

image::Image cellOf(const image::Image& picture, const PanelGrid& grid, std::size_t index) {
  image::Image cell(grid.width, grid.height, picture.format());
  for (int y = 0; y < grid.height; ++y) {
    const std::uint8_t* row =
        picture.row(grid.positions[index].y + y) + 4 * grid.positions[index].x;
    std::copy_n(row, cell.stride(), cell.row(y));
  }
  return cell;
}

TEST(GridMargins, PutCellsInRowsAndColumnsAboveTheText) {
  constexpr int kBottomRows = 50;
  const scene::Scene scene = gridScene(std::string(kColumns) + kRows);
  const PanelGrid cells = GridMargins(scene, kBottomRows).cells();
  ASSERT_EQ(cells.positions.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(cells.positions[i].x, cells.positions[0].x + static_cast<int>(i % 3) * cells.width);
    EXPECT_EQ(cells.positions[i].y, cells.positions[0].y + static_cast<int>(i / 3) * cells.height);
  }
  EXPECT_GT(cells.positions[0].x, 30) << "room for the rows' values";
  EXPECT_GT(cells.positions[0].y, 20) << "room for the columns' values";
  EXPECT_LE(cells.positions[5].x + cells.width, 480);
  EXPECT_LE(cells.positions[5].y + cells.height, 270 - kBottomRows);
}

TEST(GridMargins, LeaveNoMarginForAnAxisThatIsNotThere) {
  const PanelGrid columns = GridMargins(gridScene(kColumns), 50).cells();
  EXPECT_LT(columns.positions[0].x, 15);
  scene::Scene textless = gridScene(std::string(kColumns) + kRows);
  textless.textless = true;
  const PanelGrid bare = GridMargins(textless, 0).cells();
  EXPECT_LT(bare.positions[0].x, 15);
  EXPECT_LT(bare.positions[0].y, 15);
}

TEST(GridMargins, WriteTheValuesAndNames) {
  const auto margins = [](const std::string& grid) {
    image::Image picture(480, 270, image::PixelFormat::Rgba8);
    GridMargins(gridScene(grid), 50).draw(picture);
    return picture;
  };
  const image::Image picture = margins(std::string(kColumns) + kRows);
  for (const auto& [from, to] :
       {std::pair{"0.0001", "0.0002"}, {"tilt [rad]", "tilt [rod]"}, {"model of", "modal of"}}) {
    std::string other = std::string(kColumns) + kRows;
    other.replace(other.find(from), std::string(from).size(), to);
    EXPECT_FALSE(image::compare(picture.view(), margins(other).view(), {}).same) << to;
  }
}

TEST(GridMargins, SayWhenThereIsNoRoomOrNoLetter) {
  const auto messageOf = [](const std::vector<std::string>& overrides) -> std::string {
    try {
      GridMargins(gridScene(std::string(kColumns) + kRows, overrides), 50);
      return "no error";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_MESSAGE(messageOf({"clip.size=[64, 36]"}));
  EXPECT_MESSAGE(messageOf({"grid.rows.label=\"\xE6\x9B\xB8\""}));
}

TEST(Grid, DrawsAFrameAlikeAfterOthers) {
  const scene::Scene scene = gridScene(std::string(kColumns) + kRows);
  const image::Image alone = drawnGrid(scene, {9}), after = drawnGrid(scene, {0, 4, 11, 9});
  EXPECT_TRUE(image::compare(alone.view(), after.view(), {}).same);
  EXPECT_FALSE(image::compare(alone.view(), drawnGrid(scene, {8}).view(), {}).same);
}

TEST(Grid, ShowsInEachCellItsOwnMotion) {
  const auto cell = [](const std::string& values, std::size_t index) {
    const scene::Scene scene = gridScene(
        "columns = { key = 'initial.tilt', values = " + values + " }\n", {"overlay.show=[]"});
    return cellOf(drawnGrid(scene, {11}), GridMargins(scene, 0).cells(), index);
  };
  // A cell's place moves the book by less than a pixel's hundredth. measured 0
  constexpr image::Tolerance kMoved{.largest = 24, .failPercent = 0.5};
  const image::Image first = cell("[1.4, 0.1]", 0), second = cell("[0.1, 1.4]", 1);
  EXPECT_TRUE(image::compare(first.view(), second.view(), kMoved).same);
  EXPECT_FALSE(image::compare(first.view(), cell("[0.1, 1.4]", 0).view(), kMoved).same);
}

TEST(GridGolden, IsMatched) {
  const scene::Scene scene = gridScene(std::string(kColumns) + kRows);
  const image::Image picture = drawnGrid(scene, {9});
  if (image::testing::updatingGoldens()) image::testing::updateGolden("grid", picture.view());
  EXPECT_TRUE(image::testing::matchesGolden("grid", picture.view(), kGridTolerance));
}

TEST(GridGolden, IsNotMatchedAtAnotherTimeOrWithOtherValues) {
  const image::Image golden = image::testing::golden("grid");
  const auto matches = [&](const image::Image& picture) {
    return image::compare(golden.view(), picture.view(), kGridTolerance).same;
  };
  const std::string axes = std::string(kColumns) + kRows;
  EXPECT_FALSE(matches(drawnGrid(gridScene(axes), {7})));
  EXPECT_FALSE(
      matches(drawnGrid(gridScene(axes, {"grid.columns.values=[0.1, 0.02, 0.0001]"}), {9})));
  EXPECT_FALSE(matches(drawnGrid(gridScene(axes, {"grid.rows.label=\"books\""}), {9})));
}

}  // namespace
}  // namespace rotatebook::picture
