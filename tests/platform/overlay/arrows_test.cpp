#include "overlay/arrows.h"

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

/// Values that overlays are made from.
struct Setting {
  explicit Setting(const scene::Scene& asked)
      : scene(asked), trajectory(testing::motionOf(scene)), type() {}

  OverlayContext context() const { return {scene, trajectory, type, Scale(320, 180)}; }
  double reach() const { return scene.motions[0].body.size.norm() / 2; }

  scene::Scene scene;
  physics::Trajectory trajectory;
  Typesetter type;
};

TEST(ArrowScale, ShowsTheLargestVelocityNearlyAsLongAsTheBook) {
  const Setting setting(testing::tumbling());
  const ArrowScale scale(setting.context());
  double longest = 0;
  for (const physics::Sample& sample : setting.trajectory.samples) {
    longest = std::max(longest, scale.omegaTip(sample.angularVelocity).norm());
  }
  EXPECT_NEAR(longest / setting.reach(), 0.86, 1e-12);
}

TEST(ArrowScale, KeepsDirectionsAndRatios) {
  const Setting setting(testing::tumbling());
  const ArrowScale scale(setting.context());
  const Eigen::Vector3d velocity(1, 2, -1);
  const Eigen::Vector3d tip = scale.omegaTip(velocity);
  EXPECT_LT(tip.cross(velocity).norm(), 1e-12);
  EXPECT_GT(tip.dot(velocity), 0);
  EXPECT_LT((scale.omegaTip(2 * velocity) - 2 * tip).norm(), 1e-12);
  EXPECT_NEAR(scale.momentumTip(setting.trajectory.samples[50].angularMomentum).norm(),
              setting.reach(), 1e-12);  // measured 5e-15 off
}

TEST(ArrowScale, DoesNotGoWildWithItsMotion) {
  const Setting setting(testing::diverging());
  ASSERT_TRUE(setting.trajectory.divergedAt);
  const ArrowScale scale(setting.context());
  // A velocity like that of the start can still be seen, whatever comes later.
  const auto& samples = setting.trajectory.samples;
  EXPECT_GT(scale.omegaTip(samples.front().angularVelocity).norm(), 0.4 * setting.reach());
  for (const double factor : {1.0, 1e3, 1e300}) {
    EXPECT_LT(scale.omegaTip(factor * samples.back().angularVelocity).norm(), setting.reach());
    EXPECT_LT(scale.momentumTip(factor * samples.back().angularMomentum).norm(),
              1.1 * setting.reach());
  }
  EXPECT_EQ(scale.omegaTip({0, 0, 0}), Eigen::Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace rotatebook::overlay
