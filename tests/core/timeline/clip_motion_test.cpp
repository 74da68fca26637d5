#include "timeline/clip_motion.h"

#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/small_scene.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

// A motion of so many samples a 24th of a second apart; `diverges` says whether it ends with them.
physics::Trajectory trajectoryOf(std::size_t samples, bool diverges) {
  physics::Trajectory trajectory;
  trajectory.interval = 1.0 / 24;
  trajectory.samples.resize(samples);
  if (diverges) trajectory.divergedAt = static_cast<double>(samples) * trajectory.interval;
  return trajectory;
}

constexpr FrameRate kRate{24, 1};

TEST(ClipMotion, HasAFrameASample) {
  const ClipMotion motion({trajectoryOf(12, false)}, kRate);
  EXPECT_EQ(motion.frameCount(), 12);
  EXPECT_FALSE(motion.allDiverge());
  EXPECT_EQ(motion.sampleAt(0, 7), 7U);
  EXPECT_EQ(motion.clockFrame(7), 7);
  EXPECT_FALSE(motion.isHeld(0, 11));
}

TEST(ClipMotion, HoldsTheLastSampleForASecondWhenItDiverges) {
  const ClipMotion motion({trajectoryOf(5, true)}, kRate);
  EXPECT_TRUE(motion.allDiverge());
  EXPECT_EQ(motion.frameCount(), 5 + 24);
  EXPECT_FALSE(motion.isHeld(0, 4));
  EXPECT_TRUE(motion.isHeld(0, 5));
  EXPECT_EQ(motion.sampleAt(0, 4), 4U);
  EXPECT_EQ(motion.sampleAt(0, 28), 4U);
  EXPECT_EQ(motion.clockFrame(28), 4);
}

TEST(ClipMotion, RoundsTheHoldToWholeFrames) {
  EXPECT_EQ(ClipMotion({trajectoryOf(5, true)}, {30000, 1001}).frameCount(), 5 + 30);
  EXPECT_EQ(ClipMotion({trajectoryOf(5, true)}, {1, 1}).frameCount(), 5 + 1);
}

TEST(ClipMotion, GoesOnWhileAnyMotionDoes) {
  const ClipMotion motion({trajectoryOf(5, true), trajectoryOf(12, false)}, kRate);
  EXPECT_EQ(motion.frameCount(), 12);
  EXPECT_FALSE(motion.allDiverge());
  EXPECT_TRUE(motion.isHeld(0, 11));
  EXPECT_FALSE(motion.isHeld(1, 11));
  EXPECT_EQ(motion.sampleAt(0, 11), 4U);
  EXPECT_EQ(motion.sampleAt(1, 11), 11U);
  EXPECT_EQ(motion.clockFrame(11), 11);
}

TEST(ClipMotion, EndsASecondAfterTheLastOfItsMotionsDiverges) {
  const ClipMotion motion({trajectoryOf(5, true), trajectoryOf(8, true)}, kRate);
  EXPECT_EQ(motion.frameCount(), 8 + 24);
  EXPECT_EQ(motion.clockFrame(31), 7);
}

TEST(ClipMotion, OfASceneHasTheClipsFrames) {
  EXPECT_EQ(simulateScene(scene::testing::smallScene()).frameCount(), scene::testing::kFrames);
  const ClipMotion diverging = simulateScene(scene::testing::divergingScene());
  EXPECT_EQ(diverging.frameCount(), 5 + 24);
  EXPECT_EQ(diverging.trajectories().front().samples.size(), 5U);
}

#if GTEST_HAS_DEATH_TEST
TEST(ClipMotionDeathTest, OfAnotherSizeInAProgramIsRefused) {
  EXPECT_EXIT(
      {
        noteSize("timeline::ClipMotion", kClipMotionSize, sizeof(ClipMotion) + 16);
        try {
          simulateScene({});
        } catch (const InputError& error) {
          std::cerr << error.what();
          std::exit(1);
        }
        std::exit(0);
      },
      testing::ExitedWithCode(1), "rotatebook was built with a timeline::ClipMotion of ");
}
#endif

}  // namespace
}  // namespace rotatebook::timeline
