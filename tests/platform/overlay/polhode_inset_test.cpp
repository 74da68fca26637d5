#include "overlay/polhode_inset.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

const Eigen::Vector3d kMoments(7.3e-3, 3.2e-3, 9.9e-3);  // about x, y, z; those of a book

/// Returns the largest distance of the curve from the ellipsoid.
double distanceFromEllipsoid(const MomentumSurfaces& surfaces,
                             const std::vector<Eigen::Vector3d>& curve) {
  double farthest = 0;
  for (const Eigen::Vector3d& point : curve) {
    const double square = point.cwiseQuotient(surfaces.halfAxes()).squaredNorm();
    farthest = std::max(farthest, std::abs(square - 1));
  }
  return farthest;
}

TEST(MomentumSurfaces, HoldTheMomentumOfTheStart) {
  const Eigen::Vector3d momentum(0.03, 0.01, 0.02);
  const MomentumSurfaces surfaces(kMoments, momentum);
  EXPECT_NEAR(momentum.normalized().cwiseQuotient(surfaces.halfAxes()).norm(), 1, 1e-12);
}

TEST(MomentumSurfaces, MeetInThePolhode) {
  for (const Eigen::Vector3d& momentum :
       {Eigen::Vector3d(0.03, 0.01, 0.001), {0.03, 0.001, 0.01}, {0.03, 0, 1e-5}}) {
    const MomentumSurfaces surfaces(kMoments, momentum);
    for (const bool positive : {false, true}) {
      const auto curve = surfaces.polhode(1, positive);
      ASSERT_GT(curve.size(), 100U);
      EXPECT_LT(distanceFromEllipsoid(surfaces, curve), 1e-12);
      for (const Eigen::Vector3d& point : curve) EXPECT_NEAR(point.norm(), 1, 1e-12);
      const MomentumSurfaces other(kMoments, momentum + Eigen::Vector3d(0, 0.003, 0));
      EXPECT_GT(distanceFromEllipsoid(other, curve), 5e-3);  // measured 0.0125
    }
  }
}

TEST(MomentumSurfaces, HaveThePolhodeRoundTheAxisOfTheMotion) {
  EXPECT_EQ(MomentumSurfaces(kMoments, {0.03, 0.01, 0.001}).roundAxis(1), 1);
  EXPECT_EQ(MomentumSurfaces(kMoments, {0.03, 0.001, 0.01}).roundAxis(1), 2);
  const MomentumSurfaces surfaces(kMoments, {0.03, 0.001, 0.01});
  for (const Eigen::Vector3d& point : surfaces.polhode(1, true)) EXPECT_GT(point.z(), 0);
  for (const Eigen::Vector3d& point : surfaces.polhode(1, false)) EXPECT_LT(point.z(), 0);
}

TEST(MomentumSurfaces, HaveNoPolhodeOfASteadySpinOrABall) {
  const MomentumSurfaces ball({1, 1, 1}, {1, 2, 3});
  EXPECT_TRUE(ball.polhode(1, true).empty());
  const MomentumSurfaces top({1, 1, 2}, {1, 0, 1});
  EXPECT_EQ(top.roundAxis(1), 2);
  EXPECT_FALSE(top.polhode(1, true).empty());
  const MomentumSurfaces steady(kMoments, {0, 0.02, 0});
  for (const Eigen::Vector3d& point : steady.polhode(1, true)) {
    EXPECT_LT((point - Eigen::Vector3d::UnitY()).norm(), 1e-7);
  }
}

/// Counts the pixels beside the texts of the inset that are as bright as the point that shows the
/// present momentum, where that is on the ellipsoid's near side or on its far side.
int brightestPixels(bool near) {
  constexpr int kWidth = 640, kHeight = 360;
  const scene::Scene scene =
      testing::tumbling({"clip.size=[640, 360]", "overlay.show=['polhode']"});
  physics::Trajectory trajectory = testing::motionOf(scene);
  trajectory.samples.resize(2);
  // Toward the viewer, or away; the first is elsewhere, so that the inset itself is the same.
  const Eigen::Vector3d towardViewer(0.78, 0.41, 0.48);
  trajectory.samples[0].attitude = trajectory.samples[1].attitude.setIdentity();
  trajectory.samples[0].angularMomentum = {0.3, 0.9, -0.3};
  trajectory.samples[1].angularMomentum = near ? towardViewer : Eigen::Vector3d(-towardViewer);
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  const image::Image picture = testing::drawn(overlays, scene, 1);
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t* pixel = picture.row(y) + 4 * x;
      const Box area{1.0 * x, 1.0 * y, 1, 1};
      const bool onText = std::ranges::any_of(
          overlays.texts(), [&](const Box& text) { return text.grown(3).meets(area); });
      count += !onText && std::min({pixel[0], pixel[1], pixel[2]}) >= 236 ? 1 : 0;
    }
  }
  return count;
}

TEST(PolhodeInset, HasItsPointBrightInFrontAndFaintBehind) {
  EXPECT_GE(brightestPixels(true), 4);
  EXPECT_EQ(brightestPixels(false), 0);
}

}  // namespace
}  // namespace rotatebook::overlay
