#include "overlay/label_placement.h"

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

Layer words(int width, int height) {
  Layer layer{0, 0, width, height, {}};
  layer.pixels.assign(static_cast<std::size_t>(width * height * 4), 200);
  return layer;
}

TEST(LabelPlacement, AreBesideTheTipInItsDirection) {
  Canvas canvas(200, 100);
  LabelPlacement labels;
  const Layer letter = words(10, 12);
  labels.add(letter, {100, 50}, {3, 0}, 15);
  labels.write(canvas, {0, 0, 200, 100}, {});
  ASSERT_EQ(canvas.texts().size(), 1U);
  EXPECT_EQ(canvas.texts().front().x, 110);
  EXPECT_EQ(canvas.texts().front().y, 44);
}

TEST(LabelPlacement, GiveWayToThoseBeforeThemAndToWhatIsTaken) {
  Canvas canvas(200, 100);
  LabelPlacement labels;
  const Layer letter = words(10, 12);
  for (int i = 0; i < 4; ++i) labels.add(letter, {100, 50}, {1, 0}, 15);
  const Box taken{95, 20, 10, 20};
  labels.write(canvas, {0, 0, 200, 100}, {taken});
  std::vector<Box> all = canvas.texts();
  EXPECT_EQ(all.size(), 4U);
  all.push_back(taken);
  EXPECT_EQ(testing::meeting(all), "");
}

TEST(LabelPlacement, AreLeftOutWhereThereIsNoRoom) {
  Canvas canvas(200, 100);
  LabelPlacement labels;
  const Layer letter = words(10, 12);
  labels.add(letter, {100, 50}, {1, 0}, 15);
  labels.write(canvas, {0, 0, 200, 100}, {{50, 0, 100, 100}});
  labels.add(letter, {300, 50}, {1, 0}, 15);
  labels.write(canvas, {0, 0, 200, 100}, {});
  EXPECT_TRUE(canvas.texts().empty());
}

TEST(Meeting, FindsBoxesThatMeet) {
  EXPECT_EQ(testing::meeting({{0, 0, 10, 10}, {10, 0, 5, 5}}), "");
  EXPECT_NE(testing::meeting({{0, 0, 10, 10}, {9, 9, 5, 5}}), "");
}

}  // namespace
}  // namespace rotatebook::overlay
