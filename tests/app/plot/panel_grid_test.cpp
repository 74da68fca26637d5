#include "plot/panel_grid.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace rotatebook::plot {
namespace {

int columnsOf(const PanelGrid& grid) {
  return static_cast<int>(std::ranges::count(grid.positions, 0, &PanelGrid::Position::y));
}

TEST(PanelGrid, OfOnePanelIsThePicture) {
  const PanelGrid grid = panelGrid(1, 641, 360);
  EXPECT_EQ(grid.width, 641);
  EXPECT_EQ(grid.height, 360);
  ASSERT_EQ(grid.positions.size(), 1U);
  EXPECT_EQ(grid.positions[0].x, 0);
  EXPECT_EQ(grid.positions[0].y, 0);
}

TEST(PanelGrid, MakesThePanelsShorterSidesLongest) {
  EXPECT_EQ(columnsOf(panelGrid(2, 1280, 720)), 2);
  EXPECT_EQ(columnsOf(panelGrid(3, 1280, 720)), 3);
  EXPECT_EQ(columnsOf(panelGrid(4, 1280, 720)), 2);
  EXPECT_EQ(columnsOf(panelGrid(4, 1280, 550)), 4);
  EXPECT_EQ(columnsOf(panelGrid(5, 1280, 720)), 3);
  // As long in rows of four, which would leave a gap.
  EXPECT_EQ(columnsOf(panelGrid(6, 1280, 600)), 3);
  EXPECT_EQ(columnsOf(panelGrid(5, 1280, 600)), 3);
  EXPECT_EQ(columnsOf(panelGrid(6, 1280, 720)), 3);
  EXPECT_EQ(columnsOf(panelGrid(2, 720, 1280)), 1);
  EXPECT_EQ(columnsOf(panelGrid(6, 720, 1280)), 2);
}

TEST(PanelGrid, KeepsPanelsInThePictureAndApart) {
  constexpr int kSizes[][2] = {{1280, 720}, {720, 1280}, {3840, 2160}, {65, 40}, {640, 641}};
  for (const auto& [width, height] : kSizes) {
    for (int count = 2; count <= 6; ++count) {
      const PanelGrid grid = panelGrid(count, width, height);
      ASSERT_EQ(grid.positions.size(), static_cast<std::size_t>(count));
      for (const auto& [x, y] : grid.positions) {
        EXPECT_GE(x, 0);
        EXPECT_GE(y, 0);
        EXPECT_LE(x + grid.width, width);
        EXPECT_LE(y + grid.height, height);
      }
      for (std::size_t i = 1; i < grid.positions.size(); ++i) {
        const auto& before = grid.positions[i - 1];
        const auto& here = grid.positions[i];
        const bool below = here.y >= before.y + grid.height + 2;
        const bool beside = here.y == before.y && here.x >= before.x + grid.width + 2;
        EXPECT_TRUE(below || beside) << count << " in " << width << "x" << height;
      }
    }
  }
}

TEST(PanelGrid, CentresARowThatIsNotFull) {
  const PanelGrid grid = panelGrid(5, 1280, 720);
  const int left = grid.positions[3].x;
  const int right = 1280 - (grid.positions[4].x + grid.width);
  EXPECT_GT(left, grid.width / 4);
  EXPECT_NEAR(left, right, 1);
}

}  // namespace
}  // namespace rotatebook::plot
