#include "overlay/strip_chart.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/motion.h"
#include "overlay/palette.h"
#include "overlay/text.h"

namespace rotatebook::overlay {
namespace {

constexpr int kWidth = 640, kHeight = 360;

/// Returns the box of the lowest text on this clip's error chart: the label at the end of its time
/// axis.
Box endLabelOf(const std::vector<std::string>& overrides) {
  std::vector<std::string> all{"clip.size=[640, 360]", "overlay.show=['error']"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const scene::Scene scene = testing::tumbling(all);
  const physics::Trajectory trajectory = testing::motionOf(scene);
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  testing::drawn(overlays, scene, 0);
  return *std::ranges::max_element(overlays.texts(), {}, &Box::bottom);
}

/// Returns the width of `text` in a chart's letters. [pixels]
double widthOf(const std::string& text) {
  TextStyle style;
  style.size = Scale(kWidth, kHeight).smallLetters;
  return Typesetter().measure(text, style, kWidth).width;
}

TEST(StripChart, NamesTheTimeAtWhichItEnds) {
  ASSERT_NE(widthOf("6 s"), widthOf("12 s"));
  EXPECT_EQ(endLabelOf({}).width, widthOf("6 s"));
  EXPECT_EQ(endLabelOf({"clip.duration=1.5"}).width, widthOf("1.5 s"));
  // Of the motion, not of the video.
  EXPECT_EQ(endLabelOf({"simulation.time_per_frame=0.002"}).width, widthOf("0.36 s"));
}

TEST(StripChart, CanBeReadOverWhite) {
  const scene::Scene scene = testing::tumbling(
      {"simulation.model=particles", "overlay.show=['energy', 'energy_ladder', 'error']"});
  const physics::Trajectory trajectory = testing::motionOf(scene);
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  image::Image picture = testing::plainPicture(scene, 255);
  overlays.draw(0, testing::clipFromWorld(scene, 0), picture);
  ASSERT_GT(overlays.texts().size(), 12U);
  for (const Box& box : overlays.texts()) {
    EXPECT_GE(testing::contrastOf(box, picture), 4.5) << box.x << ", " << box.y;
  }
}

/// Returns the top of the energy's chart for a motion that reaches `highest` of its start's.
double energyTopFor(double highest) {
  physics::Trajectory trajectory;
  for (const double energy : {1.0, highest, 0.5}) {
    trajectory.samples.emplace_back().kinetic = 4 * energy;
  }
  return energyTop(trajectory);
}

TEST(EnergyTop, LeavesRoomAboveTheHighestEnergy) {
  EXPECT_DOUBLE_EQ(energyTopFor(2), 2.12);
  EXPECT_DOUBLE_EQ(energyTopFor(1.5), 1.59);
}

TEST(EnergyTop, HasALeastAndALargestValue) {
  EXPECT_EQ(energyTopFor(1), 1.15);
  EXPECT_EQ(energyTopFor(1.05), 1.15);
  EXPECT_EQ(energyTopFor(100), 3.06);
}

}  // namespace
}  // namespace rotatebook::overlay
