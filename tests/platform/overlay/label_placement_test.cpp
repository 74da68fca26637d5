#include "overlay/label_placement.h"

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

constexpr Box kArea{0, 0, 200, 100};

Layer labelOf(int width, int height) {
  Layer layer{0, 0, width, height, {}};
  layer.pixels.assign(static_cast<std::size_t>(width * height * 4), 200);
  return layer;
}

TEST(WriteBeside, PutsALabelBesideTheTipInItsDirection) {
  Canvas canvas(200, 100);
  std::vector<Box> taken;
  writeBeside(canvas, labelOf(10, 12), {100, 50}, {3, 0}, 15, kArea, taken);
  ASSERT_EQ(canvas.texts().size(), 1U);
  EXPECT_EQ(canvas.texts().front().x, 110);
  EXPECT_EQ(canvas.texts().front().y, 44);
}

TEST(WriteBeside, KeepsOutOfEarlierLabelsAndOfWhatIsTaken) {
  Canvas canvas(200, 100);
  const Layer label = labelOf(10, 12);
  const Box other{95, 20, 10, 20};
  std::vector<Box> taken{other};
  for (int i = 0; i < 4; ++i) {
    writeBeside(canvas, label, {100, 50}, {1, 0}, 15, kArea, taken);
  }
  std::vector<Box> all = canvas.texts();
  EXPECT_EQ(all.size(), 4U);
  all.push_back(other);
  EXPECT_EQ(testing::meeting(all), "");
}

TEST(WriteBeside, LeavesALabelOutIfThereIsNoRoom) {
  Canvas canvas(200, 100);
  const Layer label = labelOf(10, 12);
  std::vector<Box> taken{{50, 0, 100, 100}}, none;
  writeBeside(canvas, label, {100, 50}, {1, 0}, 15, kArea, taken);
  writeBeside(canvas, label, {300, 50}, {1, 0}, 15, kArea, none);
  EXPECT_TRUE(canvas.texts().empty());
}

TEST(Meeting, FindsBoxesThatMeet) {
  EXPECT_EQ(testing::meeting({{0, 0, 10, 10}, {10, 0, 5, 5}}), "");
  EXPECT_NE(testing::meeting({{0, 0, 10, 10}, {9, 9, 5, 5}}), "");
}

}  // namespace
}  // namespace rotatebook::overlay
