#include "overlay/layout.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

Wanted everything(int bottomRows) {
  return {.square = true, .charts = 2, .legend = true, .bottomRows = bottomRows};
}

std::vector<Box> boxesOf(const Layout& layout) {
  std::vector<Box> boxes = layout.charts;
  boxes.push_back(layout.square);
  boxes.push_back(layout.legend);
  return boxes;
}

constexpr std::array<std::array<int, 2>, 10> kSizes{{{640, 360},
                                                     {854, 480},
                                                     {1280, 720},
                                                     {1920, 1080},
                                                     {3840, 2160},
                                                     {320, 720},
                                                     {426, 720},
                                                     {640, 720},
                                                     {424, 360},
                                                     {640, 640}}};

TEST(Layout, HasBoxesWithinThePictureThatDontMeet) {
  for (const auto& [width, height] : kSizes) {
    for (const int bottomRows : {0, height / 5, height * 2 / 5}) {
      SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + ", " +
                   std::to_string(bottomRows));
      const Layout layout = layOut({width, height}, everything(bottomRows));
      ASSERT_EQ(layout.charts.size(), 2U);
      EXPECT_EQ(testing::meeting(boxesOf(layout)), "");
      for (const Box& box : boxesOf(layout)) {
        EXPECT_FALSE(box.empty());
        EXPECT_TRUE((Box{0, 0, 1.0 * width, 1.0 * height - bottomRows}.holds(box)));
      }
      EXPECT_GE(layout.bottomRows, bottomRows);
    }
  }
}

TEST(Layout, LeavesTheMiddleOfAWidePictureToTheBook) {
  for (const int bottomRows : {0, 180}) {
    const Layout layout = layOut({1280, 720}, everything(bottomRows));
    EXPECT_EQ(layout.bottomRows, bottomRows);
    // The sphere that the book keeps within nearly touches the upper and lower end.
    const double radius = (720 - bottomRows) / 2.0 / 1.08;
    for (const Box& box : boxesOf(layout)) {
      EXPECT_TRUE(box.x > 640 + radius || box.right() < 640 - radius) << box.x;
    }
  }
}

TEST(Layout, HasTheChartsBelowTheBookOfANarrowPicture) {
  const Layout layout = layOut({426, 720}, everything(0));
  EXPECT_GT(layout.bottomRows, 720 / 8);
  for (const Box& chart : layout.charts) EXPECT_GE(chart.y, 720 - layout.bottomRows);
  EXPECT_EQ(layOut({426, 720}, {.bottomRows = 7}).bottomRows, 7);
}

TEST(Layout, HasALowLegendWhereItIsInTheBodysWay) {
  const auto share = [](int width, int height) {
    const Box legend =
        layOut(Scale(width, height), {.legend = 6.4, .leastLegend = 1.28, .bottomRows = 0}).legend;
    return legend.width * legend.height / (width * height);
  };
  EXPECT_GT(share(1280, 720), 0.02);  // measured 0.0305, whole
  EXPECT_LT(share(160, 160), 0.05);   // measured 0.043; 0.21 as high as the whole one
  EXPECT_LT(share(100, 720), 0.05);   // measured 0.013; the whole one is as wide as the picture
  EXPECT_EQ(share(80, 80), 0);
}

}  // namespace
}  // namespace rotatebook::overlay
