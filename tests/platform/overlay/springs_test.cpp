#include <gtest/gtest.h>

#include "overlay/motion.h"
#include "overlay/rounded.h"

namespace rotatebook::overlay {
namespace {

/// Returns the surplus of red over blue on the picture of a book scaled by `factor`, without its
/// legend.
double rednessOf(double factor) {
  const scene::Scene scene =
      testing::tumbling({"clip.size=[320, 180]", "overlay.show=['springs']",
                         "simulation.model='particles'", "simulation.integrator='verlet'"});
  physics::Trajectory trajectory = testing::motionOf(scene);
  trajectory.samples.resize(1);
  trajectory.samples.front().cage *= factor;
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  const image::Image picture = testing::drawn(overlays, scene, 0);
  double redness = 0;
  for (int y = 0; y < 130; ++y) {
    const std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, pixel += 4) redness += pixel[0] - pixel[2];
  }
  return redness;
}

TEST(Springs, AreOrangeWhereStretchedAndBlueWhereCompressed) {
  EXPECT_GT(rednessOf(1.02), 200'000);        // measured 421,704
  EXPECT_LT(rednessOf(0.98), -200'000);       // measured -374,400
  EXPECT_LT(std::abs(rednessOf(1)), 20'000);  // measured -5,334
}

TEST(RoundedUp, GivesOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(roundedUp(0.013), 0.02);
  EXPECT_DOUBLE_EQ(roundedUp(0.02), 0.02);
  EXPECT_DOUBLE_EQ(roundedUp(0.021), 0.05);
  EXPECT_DOUBLE_EQ(roundedUp(0.06), 0.1);
  EXPECT_DOUBLE_EQ(roundedUp(1), 1);
  EXPECT_DOUBLE_EQ(roundedUp(700), 1000);
  EXPECT_DOUBLE_EQ(roundedDown(0.019), 0.01);
  EXPECT_DOUBLE_EQ(roundedDown(0.02), 0.02);
  EXPECT_DOUBLE_EQ(roundedDown(700), 500);
}

}  // namespace
}  // namespace rotatebook::overlay
