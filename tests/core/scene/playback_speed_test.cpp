#include "scene/playback_speed.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

constexpr double kRounding = 1e-14;  // [s]; measured 1.8e-15

/// The speed at a time of the video, from times around it.
double speedAt(const PlaybackSpeed& speed, double videoTime) {
  constexpr double kAround = 1e-6;  // [s]
  return (speed.timeAt(videoTime + kAround) - speed.timeAt(videoTime - kAround)) / (2 * kAround);
}

TEST(PlaybackSpeed, IsConstantWithoutStretches) {
  EXPECT_EQ((PlaybackSpeed{.constant = 0.25}.timeAt(8)), 2);
}

TEST(PlaybackSpeed, CountsTheTimeOfEachStretchAtItsSpeed) {
  const PlaybackSpeed speed{.stretches = {{3, 5, 0.2}, {8, 9, 4}}};
  EXPECT_EQ(speed.timeAt(0), 0);
  EXPECT_EQ(speed.timeAt(2.7), 2.7);
  EXPECT_NEAR(speed.timeAt(4), 3.2, kRounding);
  EXPECT_NEAR(speed.timeAt(6), 4.4, kRounding);
  EXPECT_NEAR(speed.timeAt(10), 6.4 + 4 + 1, kRounding);
}

TEST(PlaybackSpeed, PassesSmoothlyFromOneToTheNext) {
  constexpr double kBound = 1e-8;  // measured 2.2e-10
  const PlaybackSpeed speed{.stretches = {{3, 5, 0.2}}};
  EXPECT_NEAR(speedAt(speed, 2.7), 1, kBound);
  EXPECT_NEAR(speedAt(speed, 3), 0.6, kBound);
  EXPECT_NEAR(speedAt(speed, 3.125), 1 - 0.8 * (3 * 0.5625 - 2 * 0.421875), kBound);
  EXPECT_NEAR(speedAt(speed, 3.3), 0.2, kBound);
  for (double time = 2.5; time < 5.5; time += 1e-3) {  // at most 3/2 * 0.8 / 0.5 s = 2.4 /s
    EXPECT_LT(std::fabs(speedAt(speed, time + 1e-3) - speedAt(speed, time)), 2.5e-3);
  }
}

TEST(PlaybackSpeed, PassesFasterWithinShortStretches) {
  constexpr double kBound = 1e-8;  // measured 1.4e-10
  const PlaybackSpeed speed{.stretches = {{3, 3.2, 0.2}}};
  EXPECT_NEAR(speedAt(speed, 2.89), 1, kBound);
  EXPECT_NEAR(speedAt(speed, 3.1), 0.2, kBound);
  EXPECT_NEAR(speedAt(speed, 3.31), 1, kBound);
  EXPECT_NEAR(speed.timeAt(4), 3 + 0.04 + 0.8, kRounding);
}

TEST(PlaybackSpeed, HasItsFirstSpeedFromTheStartAndJoinsStretches) {
  const PlaybackSpeed speed{.stretches = {{0, 2, 0.5}, {2, 3, 2}}};
  EXPECT_EQ(speed.timeAt(1), 0.5);
  EXPECT_NEAR(speed.timeAt(2.5), 1 + 1, kRounding);
  EXPECT_NEAR(speed.timeAt(4), 1 + 2 + 1, kRounding);
}

TEST(PlaybackSpeed, OfZeroHoldsTheTimeToTheLastBit) {
  const PlaybackSpeed speed{.stretches = {{3, 5, 0}, {5, 6, 0}, {7, 8, 0.2}}};
  const double held = speed.timeAt(3.25);
  EXPECT_NEAR(held, 3, kRounding);
  for (double time = 3.25; time < 5.75; time += 0.01) EXPECT_EQ(speed.timeAt(time), held) << time;
  EXPECT_NEAR(speed.timeAt(6.5), 3.5, kRounding);
  EXPECT_EQ((PlaybackSpeed{.stretches = {{0, 2, 0}}}.timeAt(1.5)), 0);
  EXPECT_EQ((PlaybackSpeed{.stretches = {{0, 2, 0}}}.timeAt(1.99, 2)), 0) << "until the end";
}

TEST(PlaybackSpeed, IsTheStatedOneAtEachTime) {
  const PlaybackSpeed speed{.stretches = {{1, 2, 0.5}, {3, 4, 0}}};
  EXPECT_EQ(speed.at(0.9), 1);
  EXPECT_EQ(speed.at(1), 0.5);
  EXPECT_EQ(speed.at(2), 1);
  EXPECT_EQ(speed.at(3.5), 0);
  EXPECT_EQ((PlaybackSpeed{.constant = 20}.at(7)), 20);
}

TEST(ClipSection, ReadsAndPrintsStretchesOfSpeed) {
  const Scene scene = sceneFrom(
      "[clip]\nfps = 10\nspeed = [{ from = '500 ms', to = 1, value = 0.5 }, "
      "{ from = 1, to = 2, value = 3 }]");
  EXPECT_EQ(scene.timePerFrame(), 0.1);
  EXPECT_EQ(scene.clip.speed->stretches, (std::vector<SpeedStretch>{{0.5, 1, 0.5}, {1, 2, 3}}));
  EXPECT_EQ(timeAt(scene, 20), scene.clip.speed->timeAt(2));
  EXPECT_FALSE(hasEvenTimes(scene));
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").clip, scene.clip);
}

TEST(ClipSection, RefusesStretchesThatMakeNoSense) {
  const auto refusal = [](const std::string& speed) { return errorOf("clip.speed = " + speed); };
  EXPECT_EQ(refusal("'fast'"),
            "a.toml:1:14: clip.speed must be a number from 1e-6 to 1e6, or stretches such as "
            "[{ from = 3, to = 5, value = 0.2 }], not \"fast\"");
  EXPECT_EQ(refusal("[{ from = 3, to = 5 }]"), "a.toml:1:15: clip.speed needs from, to and value");
  EXPECT_EQ(refusal("[{ from = 5, to = 3, value = 2 }]"),
            "a.toml:1:15: clip.speed must end after it begins, not go from 5 s to 3 s");
  EXPECT_EQ(refusal("[{ from = 3, to = 5, value = 2 }, { from = 4, to = 6, value = 1 }]"),
            "a.toml:1:48: the stretches of clip.speed must follow each other, but one begins at 4 "
            "s, before the last has ended at 5 s");
  EXPECT_EQ(
      refusal("[{ from = 3, to = 5, value = -2 }]"),
      "a.toml:1:43: clip.speed.value must be 0, which holds the picture, or a number up to 1e6, "
      "not -2");
}

}  // namespace
}  // namespace rotatebook::scene
